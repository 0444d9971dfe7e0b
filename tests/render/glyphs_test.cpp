#include "sinew/render/glyphs.h"

#include <gtest/gtest.h>

namespace sinew {
namespace {

Document lollipop(NodeType tip) {
    Document document;
    document.nodes = {{.id = 1, .radius = 0.25},
                      {.id = 2, .parent = 0, .position = {0, 0, 2}, .radius = 0.25},
                      {.id = 3, .parent = 1, .position = {3, 0, 2}, .radius = 0.5, .type = tip}};
    return document;
}

TEST(Glyphs, ABoneRunsFromParentToChildWithTheirRadii) {
    const Glyphs glyphs = make_glyphs(lollipop(NodeType::sphere));
    ASSERT_EQ(glyphs.bones.size(), 2u);
    EXPECT_EQ(glyphs.of(GlyphShape::sphere).size(), 3u);
    const Bounds box = Glyphs{.bones = glyphs.bones}.bounds();
    EXPECT_EQ(box.min(), Vec3f(-0.25f, -0.5f, -0.25f));
    EXPECT_EQ(box.max(), Vec3f(3.5f, 0.5f, 2.5f));
}

TEST(Glyphs, AConeEndsInAPoint) {
    const Glyphs glyphs = make_glyphs(lollipop(NodeType::cone));
    float smallest = 1;
    for (const BoneGlyph& bone : glyphs.bones)
        smallest = std::min({smallest, bone.from_radius, bone.to_radius});
    EXPECT_EQ(smallest, 0);
}

TEST(Glyphs, AHemisphereEndsFlatAcrossItsBone) {
    const Glyphs glyphs = make_glyphs(lollipop(NodeType::hemisphere));
    ASSERT_EQ(glyphs.of(GlyphShape::half_sphere).size(), 1u);
    EXPECT_TRUE(glyphs.of(GlyphShape::half_sphere)[0].z.normalized().isApprox(Vec3f::UnitX()));
    EXPECT_EQ(glyphs.bones[0].from_flat + glyphs.bones[0].to_flat + glyphs.bones[1].from_flat +
                  glyphs.bones[1].to_flat,
              1);
}

TEST(Glyphs, ACubeHasItsSizeAndTurnsWithItsBone) {
    Document document = lollipop(NodeType::cube);
    document.nodes[2].size = Vec3(2, 4, 6);
    document.nodes[2].roll = 90;
    GlyphStyle style;
    style.node_factor = 1;
    const Glyphs glyphs = make_glyphs(document, style);
    ASSERT_EQ(glyphs.of(GlyphShape::box).size(), 1u);
    const ShapeGlyph& box = glyphs.of(GlyphShape::box)[0];
    EXPECT_TRUE(box.z.isApprox(Vec3f(3, 0, 0), 1e-5f)) << "z along the bone";
    // |z.X| > 0.9: x starts as the world's Y; a quarter turn about the bone takes it to the world's Z.
    EXPECT_TRUE(box.x.isApprox(Vec3f(0, 0, 1), 1e-5f));
    EXPECT_TRUE(box.y.isApprox(Vec3f(0, -2, 0), 1e-5f));
}

TEST(Glyphs, ImagesOfASymmetryAreDrawnToo) {
    Document document = lollipop(NodeType::sphere);
    document.symmetry = {.kind = Symmetry::Kind::mirror, .axis = 0};
    const Glyphs glyphs = make_glyphs(document);
    EXPECT_EQ(glyphs.bones.size(), 3u) << "one bone lies in the plane";
    EXPECT_EQ(glyphs.of(GlyphShape::sphere).size(), 4u);
    const Bounds box = Glyphs{.bones = glyphs.bones}.bounds();
    EXPECT_EQ(box.min().x(), -box.max().x());
}

TEST(Glyphs, LinksAreBonesToo) {
    Document document = lollipop(NodeType::sphere);
    document.links = {{0, 2}};
    EXPECT_EQ(make_glyphs(document).bones.size(), 3u);
}

}  // namespace
}  // namespace sinew
