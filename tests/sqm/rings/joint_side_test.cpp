#include "sinew/sqm/rings/joint_side.h"

#include <cmath>

#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

/// What the joint takes of one of its paths, found again on its own.
JointSide side_of(const Stages& s, std::int32_t path, int end) {
    Stations out;
    const StationOptions options;
    PathWork work{s.skeleton, s.network, s.polyhedra, s.refinement, s.surfaces, s.points, options, out};
    work.sides = s.refinement.path_sides[path];
    JointSide side;
    take_joint(work, s.network.path_end[path][end], end == 1, side);
    return side;
}

TEST(JointSide, HasTheRingAsThePathSeesIt) {
    const Stages s(cube_of_struts());
    for (std::int32_t p = 0; p < s.network.path_count(); ++p)
        for (const int end : {0, 1}) {
            const JointSide side = side_of(s, p, end);
            ASSERT_EQ(std::ssize(side.points), s.refinement.path_sides[p]);
            Vec3 turn = Vec3::Zero();  // counter-clockwise about the way of the path
            for (std::size_t k = 0; k < side.points.size(); ++k)
                turn += side.points[k].cross(side.points[(k + 1) % side.points.size()]);
            EXPECT_GT(turn.dot(end == 0 ? side.axis : Vec3(-side.axis)), 0);
        }
}

TEST(JointSide, KnowsItsFarthestAndItsWidestPoint) {
    property::Random random(41);
    const Stages s(random_tree(random, 4));
    for (std::int32_t p = 0; p < s.network.path_count(); ++p)
        for (const int end : {0, 1}) {
            if (!s.network.path_end[p][end].at_joint()) continue;
            const JointSide side = side_of(s, p, end);
            for (const Vec3& point : side.points) {
                EXPECT_LE(point.norm(), side.farthest + 1e-12);
                EXPECT_GE(point.normalized().dot(side.axis), side.widest - 1e-12);
                EXPECT_LE(point.dot(side.axis), side.reach + 1e-12);
            }
        }
}

/// Two arms so and so far from each other: the border between their cells is half as far from either.
TEST(JointSide, ReachesToWhereTheTubeHasLeftItsNeighbour) {
    for (const double half : {0.2, 0.35, 0.5}) {
        const Vec3 left(std::cos(half), -std::sin(half), 0), right(std::cos(half), std::sin(half), 0);
        const Stages s(star(std::vector<Vec3>{left, right, -Vec3::UnitX()}, 30, 1));
        for (std::int32_t p = 0; p < s.network.path_count(); ++p) {
            const int end = s.network.path_end[p][0].at_joint() ? 0 : 1;
            const JointSide side = side_of(s, p, end);
            if (side.axis.x() < 0) continue;
            EXPECT_NEAR(side.room, std::tan(half), 1e-9);
            EXPECT_GE(side.reach, 1 / std::tan(half) - 1e-9);
        }
    }
}

TEST(JointSide, IsNoneAtALeaf) {
    const Stages s(star(fan(3)));
    EXPECT_TRUE(side_of(s, 0, 0).any() != side_of(s, 0, 1).any());
}

}  // namespace
}  // namespace sinew::sqm
