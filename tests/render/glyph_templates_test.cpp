#include "sinew/render/glyph_templates.h"

#include <gtest/gtest.h>

#include <numbers>

namespace sinew::gl {
namespace {

constexpr double pi = std::numbers::pi;

/// Negative or far off where a triangle is turned or missing.
double volume_of(const ShapeTemplates& templates, GlyphShape shape) {
    const IndexRange range = templates.ranges[static_cast<std::size_t>(shape)];
    double volume = 0;
    for (std::uint32_t i = range.first; i < range.first + range.count; i += 3) {
        const auto at = [&](std::uint32_t k) {
            return Eigen::Map<const Vec3f>(templates.vertices[templates.indices[i + k]].position)
                .cast<double>()
                .eval();
        };
        volume += at(0).dot(at(1).cross(at(2))) / 6;
    }
    return volume;
}

TEST(GlyphTemplates, HaveTheVolumesOfTheirShapes) {
    const ShapeTemplates templates = shape_templates(64);
    EXPECT_NEAR(volume_of(templates, GlyphShape::sphere), 4 * pi / 3, 0.02);
    EXPECT_NEAR(volume_of(templates, GlyphShape::half_sphere), 2 * pi / 3, 0.02);
    EXPECT_NEAR(volume_of(templates, GlyphShape::cone), 2 * pi / 3, 0.02);
    EXPECT_NEAR(volume_of(templates, GlyphShape::box), 8, 1e-6);
}

TEST(GlyphTemplates, NormalsAreUnitAndPointOut) {
    for (const TemplateVertex& v : shape_templates(16).vertices) {
        const Eigen::Map<const Vec3f> normal(v.normal), position(v.position);
        EXPECT_NEAR(normal.norm(), 1, 1e-5);
        EXPECT_GE(normal.dot(position), -1e-5f);
    }
}

TEST(GlyphTemplates, ABoneHasTwoCapsAndASide) {
    const BoneTemplate bone = bone_template(12);
    for (const auto& v : bone.vertices) EXPECT_NEAR(v[0] * v[0] + v[1] * v[1], 1, 1e-6);
    const std::size_t rows = bone.vertices.size() / 13;
    EXPECT_EQ(bone.indices.size(), 6u * 12 * (rows - 3))
        << "rows of three parts, each with a row of cells fewer than of vertices";
}

}  // namespace
}  // namespace sinew::gl
