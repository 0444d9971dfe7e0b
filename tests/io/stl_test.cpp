#include "sinew/io/stl.h"

#include <gtest/gtest.h>

#include "mesh/shapes.h"
#include "sinew/io/byte_order.h"
#include "sinew/mesh/triangulate.h"

namespace sinew {
namespace {

Vec3f vector_at(const std::string& bytes, std::size_t at) {
    Vec3f v;
    for (int k = 0; k < 3; ++k)
        v[k] = get_bytes<float>(bytes.data() + at + 4 * std::size_t(k), std::endian::little);
    return v;
}

TEST(Stl, HoldsEveryTriangleWithItsNormal) {
    const QuadMesh mesh = shapes::tube(4, 7);
    const auto triangles = triangulate(mesh).triangles;
    const std::string bytes = stl_bytes(mesh);
    ASSERT_EQ(bytes.size(), 84 + 50 * triangles.size());
    EXPECT_EQ(get_bytes<std::uint32_t>(bytes.data() + 80, std::endian::little), triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        Vec3f corner[3];
        for (std::size_t i = 0; i < 3; ++i) {
            corner[i] = vector_at(bytes, 84 + 50 * t + 12 * (i + 1));
            EXPECT_EQ(corner[i], mesh.positions[triangles[t][i]]);
        }
        const Vec3f normal = vector_at(bytes, 84 + 50 * t);
        EXPECT_NEAR(normal.norm(), 1, 1e-6);
        for (int i = 1; i < 3; ++i) EXPECT_NEAR(normal.dot(corner[i] - corner[0]), 0, 1e-5);
        EXPECT_GT(normal.dot((corner[1] - corner[0]).cross(corner[2] - corner[0])), 0) << "outward";
    }
}

TEST(Stl, OfATriangleWithoutAreaTheNormalIsZero) {
    const QuadMesh mesh = shapes::from_faces({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
    EXPECT_EQ(vector_at(stl_bytes(mesh), 84), Vec3f(0, 0, 0));
}

}  // namespace
}  // namespace sinew
