#include "sinew/sqm/surface/find_surfaces.h"

#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

/// Two joints on the x axis, each with two more bones at right angles to the bone between them.
struct Pair {
    Stages s;
    Pair(double length, double near, double far)
        : s([&] {
              Document d;
              add(d, -1, {0, 0, 0}, near);
              add(d, 0, {length, 0, 0}, far);
              for (const double side : {-4.0, 4.0}) add(d, 0, {0, side, 0}, near);
              for (const double side : {-4.0, 4.0}) add(d, 1, {length, 0, side}, far);
              return d;
          }()) {}
    /// What is known of the bone between both, as seen from one of them.
    std::int32_t slot(int joint) const {
        for (std::int32_t slot = s.network.slot_first[joint]; slot < s.network.slot_first[joint + 1]; ++slot)
            if (s.network.between_joints(s.network.slot_path[slot].path)) return slot;
        return -1;
    }
    double limit(int joint) const { return s.surfaces.limit[slot(joint)]; }
    bool crowded() const {
        EXPECT_EQ(s.surfaces.crowded[slot(0)], s.surfaces.crowded[slot(1)]);
        return s.surfaces.crowded[slot(0)] != 0;
    }
};

TEST(FindSurfaces, ConesLeaveTheJoint) {
    const Pair pair(5, 0.5, 0.3);
    const ConeFrom &near = pair.s.surfaces.cone[pair.slot(0)], &far = pair.s.surfaces.cone[pair.slot(1)];
    EXPECT_TRUE(near.axis.isApprox(Vec3::UnitX(), 1e-12));
    EXPECT_TRUE(far.axis.isApprox(-Vec3::UnitX(), 1e-12));
    EXPECT_EQ(near.length, 5);
    EXPECT_EQ(near.near, 0.5);
    EXPECT_EQ(near.far, 0.3);
    EXPECT_EQ(far.near, 0.3);
    EXPECT_EQ(far.far, 0.5);
    EXPECT_EQ(pair.s.surfaces.only_cones, (std::vector<std::uint8_t>{1, 1}));
}

/// A tube of radius r at right angles to its neighbours has left them at the height r: that much each joint
/// wants, and what is left over they share by their radii.
TEST(FindSurfaces, JointsShareTheBoneBetweenThem) {
    for (const double radius : {0.2, 0.4, 0.6}) {
        const Pair even(5, radius, radius);
        EXPECT_FALSE(even.crowded());
        EXPECT_NEAR(even.limit(0), even.limit(1), 1e-9);
        EXPECT_LT(even.limit(0) + even.limit(1), 5);
        EXPECT_GT(even.limit(0) + even.limit(1), 0.8 * 5);
    }
    const Pair uneven(5, 0.8, 0.2);
    EXPECT_FALSE(uneven.crowded());
    EXPECT_NEAR(uneven.limit(0) + uneven.limit(1), Pair(5, 0.3, 0.3).limit(0) * 2, 1e-9);
    EXPECT_GT(uneven.limit(0), 3 * uneven.limit(1));
    EXPECT_GT(uneven.limit(1), 0.2);
}

TEST(FindSurfaces, ABoneTooShortForBothJointsIsCrowded) {
    EXPECT_FALSE(Pair(1.2, 0.5, 0.5).crowded());
    const Pair tight(1.0, 0.5, 0.5);
    EXPECT_TRUE(tight.crowded());
    EXPECT_NEAR(tight.limit(0), tight.limit(1), 1e-9);
    EXPECT_LT(tight.limit(0) + tight.limit(1), 1.0);
}

TEST(FindSurfaces, JointsEndBeforeTheNextNodeButNotBeforeALeaf) {
    Document d = star(fan(3), 4, 0.5);
    add(d, 1, 2 * d.nodes[1].position, 0.5);
    const Stages s(d);
    int leaves = 0;
    for (std::int32_t slot = 0; slot < 3; ++slot) {
        const bool leaf = s.network.nodes(s.network.slot_path[slot].path).size() == 2;
        leaves += leaf;
        if (leaf)
            EXPECT_GT(s.surfaces.limit[slot], 1e100);
        else
            EXPECT_TRUE(s.surfaces.limit[slot] > 4 - 0.5 && s.surfaces.limit[slot] < 4);
    }
    EXPECT_EQ(leaves, 2);
}

/// A leaf beside a longer bone in its own direction: its pole is inside the other, so the joint ends short of
/// it, on the round end.
TEST(FindSurfaces, JointsEndBeforeThePoleOfALeafInsideAnotherBone) {
    const Stages s(star(std::vector<Vec3>{{0, 0, 1}, {0, 0, 2}, {1, 0, -1}}, 3, 0.5));
    std::vector<double> limits = s.surfaces.limit;
    std::sort(limits.begin(), limits.end());
    EXPECT_TRUE(limits[0] > 3 && limits[0] < 3.5);
    EXPECT_TRUE(limits[1] > 6 && limits[1] < 6.5);
    EXPECT_GT(limits[2], 1e100);
}

TEST(FindSurfaces, BeamsHaveTheOutlinesOfTheirEnds) {
    Document d = star(std::vector<Vec3>{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, 4, 0.5);
    d.nodes[1].section = Section::rectangular;
    d.nodes[1].scale = {1, 2, 1};
    const Stages s(d);
    ASSERT_EQ(s.surfaces.beams.size(), 1u);
    EXPECT_EQ(s.surfaces.only_cones, std::vector<std::uint8_t>{0});
    const BeamFrom& beam = s.surfaces.beams[0];
    EXPECT_TRUE(beam.z.isApprox(Vec3::UnitX(), 1e-9));
    EXPECT_NEAR(beam.x.cross(beam.y).dot(beam.z), 1, 1e-9);
    EXPECT_EQ(beam.length, 4);
    EXPECT_TRUE(beam.near.isApprox(Vec2(0.5, 0.5), 1e-9));
    EXPECT_TRUE(beam.far.isApprox(Vec2(0.5, 1), 1e-9));
    EXPECT_EQ(beam.section, Section::rectangular);
}

}  // namespace
}  // namespace sinew::sqm
