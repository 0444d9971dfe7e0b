#include "sinew/render/normals.h"

#include <gtest/gtest.h>

#include "render/shapes.h"

namespace sinew {
namespace {

/// One a corner: its own where creases part it, else its vertex's.
std::vector<Vec3f> at_corners(const QuadMesh& mesh) {
    const Normals normals = normals_of(mesh);
    std::vector<Vec3f> result;
    for (const std::uint32_t v : mesh.corners) result.push_back(normals.vertices[v]);
    for (const SplitNormal& split : normals.splits) result[split.corner] = split.normal;
    return result;
}

TEST(Normals, AreRadialOnASphere) {
    const Vec3f centre(3, -2, 1);
    for (const float radius : {1e-6f, 1.f, 1e5f}) {
        const QuadMesh mesh = shapes::sphere(centre * radius, radius, 16);
        const std::vector<Vec3f> normals = at_corners(mesh);
        for (std::size_t c = 0; c < normals.size(); ++c) {
            const Vec3f radial = (mesh.positions[mesh.corners[c]] - centre * radius) / radius;
            EXPECT_LT((normals[c] - radial).norm(), 2e-5f) << "radius " << radius << ", corner " << c;
        }
    }
}

TEST(Normals, OfFacesPointOutward) {
    const QuadMesh mesh = shapes::box({0, 0, 0}, {1, 2, 3});
    const std::vector<Vec3f> normals = normals_of(mesh).faces;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        Vec3f middle = Vec3f::Zero();
        for (const auto v : mesh.face(f)) middle += mesh.positions[v] / 4;
        EXPECT_TRUE(normals[f].isApprox(middle.normalized()));
    }
}

TEST(Normals, StopAtCreases) {
    const QuadMesh round = shapes::box({0, 0, 0}, {1, 1, 1}), sharp = shapes::box({0, 0, 0}, {1, 1, 1}, true);
    const std::vector<Vec3f> faces = normals_of(sharp).faces;
    const std::vector<Vec3f> round_normals = at_corners(round), sharp_normals = at_corners(sharp);
    for (std::size_t c = 0; c < sharp.corners.size(); ++c) {
        EXPECT_TRUE(sharp_normals[c].isApprox(faces[c / 4]));
        EXPECT_TRUE(round_normals[c].isApprox(round.positions[round.corners[c]].normalized()));
    }
}

TEST(Normals, ACreaseThatEndsPartsNothingBehindItsEnd) {
    QuadMesh mesh = shapes::grid(2);
    mesh.positions[4].y() = -0.5f;  // the middle comes forward
    mesh.features.creases.push_back({{4, 7}, 10});
    const std::vector<Vec3f> normals = at_corners(mesh);
    for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
        if (mesh.corners[c] != 4) continue;
        EXPECT_TRUE(normals[c].isApprox(-Vec3f::UnitY(), 1e-5f));
    }
}

TEST(Normals, AFaceWithoutAreaHarmsNothing) {
    QuadMesh mesh = shapes::grid(1);
    mesh.add_face(std::array<std::uint32_t, 3>{0, 0, 1});
    const std::vector<Vec3f> normals = at_corners(mesh);
    for (const Vec3f& n : normals) EXPECT_TRUE(n.allFinite());
    EXPECT_TRUE(normals[4].isApprox(-Vec3f::UnitY())) << "borrowed from the quad";
}

}  // namespace
}  // namespace sinew
