#include "sinew/mesh/weld.h"

#include <gtest/gtest.h>

#include "mesh/shapes.h"
#include "sinew/mesh/validate.h"

namespace sinew {
namespace {

TEST(Weld, PutsASoupTogether) {
    const QuadMesh sphere = shapes::sphere(12);
    QuadMesh soup;
    for (std::size_t f = 0; f < sphere.face_count(); ++f) {
        const std::uint32_t v = shapes::index_of(soup.vertex_count());
        for (const std::uint32_t corner : sphere.face(f)) soup.positions.push_back(sphere.positions[corner]);
        soup.add_face(std::array{v, v + 1, v + 2, v + 3});
    }
    const QuadMesh mesh = welded(soup);
    EXPECT_EQ(mesh.vertex_count(), sphere.vertex_count());
    EXPECT_TRUE(validate(mesh).solid());
}

TEST(Weld, KeepsTheOrderAndDropsWhatIsLeftOver) {
    const QuadMesh mesh =
        shapes::from_faces({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {-0.0f, 0, 0}, {0, 1, 0}, {1, 0, 0}},
                           {{1, 2, 4}, {3, 5, 4}, {1, 3, 2}, {4, 1, 3, 2}, {1, 2, 4, 3}});
    const QuadMesh result = welded(mesh);
    EXPECT_EQ(result.positions, (std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(result.corners, (std::vector<std::uint32_t>{0, 1, 2, 0, 1, 2, 2, 0, 1, 0, 1, 2}));
    EXPECT_EQ(result.face_count(), 4u);
}

}  // namespace
}  // namespace sinew
