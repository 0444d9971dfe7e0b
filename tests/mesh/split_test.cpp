#include "sinew/mesh/split.h"

#include <gtest/gtest.h>

#include "mesh/shapes.h"
#include "sinew/mesh/normals.h"
#include "sinew/mesh/validate.h"
#include "sinew/mesh/weld.h"

namespace sinew {
namespace {

QuadMesh sharp_cube() {
    QuadMesh cube = shapes::cube();
    for (const MeshEdge& edge : build_topology(cube).edges) cube.features.creases.push_back({edge, 10});
    return cube;
}

TEST(Split, ASharpCubeHasSixFlatSides) {
    const QuadMesh cube = sharp_cube();
    const QuadMesh split = split_at_creases(cube);
    EXPECT_EQ(split.vertex_count(), 24u);
    EXPECT_EQ(validate(split).components, 6);
    for (const Vec3f& normal : vertex_normals(split)) EXPECT_FLOAT_EQ(normal.cwiseAbs().maxCoeff(), 1);
    const QuadMesh again = welded(split);
    EXPECT_EQ(again.positions, cube.positions);
    EXPECT_EQ(again.corners, cube.corners);
}

TEST(Split, ARimPartsTheEndOfATubeFromItsSide) {
    QuadMesh tube = shapes::tube(4, 9);
    for (std::uint32_t i = 0; i < 9; ++i) tube.features.creases.push_back({{i, (i + 1) % 9}, 3});
    const QuadMesh split = split_at_creases(tube);
    EXPECT_EQ(split.vertex_count(), tube.vertex_count() + 9);
    EXPECT_EQ(validate(split).components, 2);
    EXPECT_EQ(validate(split).boundary_edges.count, 18);
}

TEST(Split, NothingIsTakenApartWhereACreaseEndsOrIsSoft) {
    QuadMesh cube = shapes::cube();
    cube.features.creases = {{{0, 1}, 10}, {{2, 3}, 0.5f}, {{0, 7}, 10}};
    const QuadMesh split = split_at_creases(cube);
    EXPECT_EQ(split.vertex_count(), 8u);
    EXPECT_EQ(split.corners, cube.corners);
}

}  // namespace
}  // namespace sinew
