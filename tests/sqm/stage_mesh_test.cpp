#include "sinew/sqm/stage_mesh.h"

#include "sinew/mesh/validate.h"
#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

TEST(StageMesh, OfPolyhedraIsAHullAJointOnItsBall) {
    property::Random random(21);
    const Stages s(random_tree(random, 3));
    const QuadMesh mesh = polyhedra_mesh(s.skeleton, s.network, s.polyhedra);
    const Validation v = validate(mesh);
    EXPECT_TRUE(v.closed());
    EXPECT_EQ(v.components, s.network.joint_count());
    EXPECT_EQ(v.euler, 2 * v.components);
    ASSERT_EQ(std::ssize(mesh.positions), s.polyhedra.cell_count());
    for (std::int32_t j = 0; j < s.network.joint_count(); ++j)
        for (std::int32_t c = s.polyhedra.cell_first[j]; c < s.polyhedra.cell_first[j + 1]; ++c) {
            const std::int32_t node = s.network.joint_node[j];
            EXPECT_NEAR((mesh.positions[c].cast<double>() - s.skeleton.position[node]).norm(),
                        s.skeleton.radius[node], 1e-5);
        }
}

TEST(StageMesh, OfRefinementIsABallAJointWithAPolygonACell) {
    property::Random random(22);
    const Stages s(random_tree(random, 3), 8);
    const QuadMesh mesh = refined_mesh(s.skeleton, s.network, s.polyhedra, s.refinement, s.points);
    const Validation v = validate(mesh);
    EXPECT_TRUE(v.solid());
    EXPECT_EQ(v.components, s.network.joint_count());
    EXPECT_EQ(v.euler, 2 * v.components);
    ASSERT_EQ(std::ssize(mesh.face_offsets) - 1, s.polyhedra.cell_count());
    for (std::int32_t c = 0; c < s.polyhedra.cell_count(); ++c)
        EXPECT_EQ(std::ssize(mesh.face(c)), s.round_cell(c));
}

}  // namespace
}  // namespace sinew::sqm
