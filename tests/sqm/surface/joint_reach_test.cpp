#include "sinew/sqm/surface/joint_reach.h"

#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

TEST(JointReach, OfConesIsTheirUnion) {
    property::Random random(14);
    const Stages s(star(random_directions(random, 5), 4, 0.5));
    for (int i = 0; i < 100; ++i) {
        const Vec3 ray = random.direction();
        double expected = 0;
        for (const ConeFrom& cone : s.surfaces.cone) expected = std::max(expected, cone.exit(ray));
        EXPECT_EQ(exit_of_joint(s.network, s.surfaces, 0, Vec3::Zero(), ray), expected);
    }
}

/// No ray goes further along any bone than the joint may; one that would not go so far leaves the surface.
TEST(JointReach, EndsWhereTheJointDoes) {
    property::Random random(31);
    const Stages s(cube_of_struts(2, 0.3));
    int cut = 0;
    for (std::int32_t joint = 0; joint < s.network.joint_count(); ++joint) {
        const Vec3& centre = s.skeleton.position[s.network.joint_node[joint]];
        for (int i = 0; i < 400; ++i) {
            // Half of the rays near a bone: others leave the surface before any limit.
            const std::int32_t bone = s.network.slot_first[joint] + random.below(3);
            const Vec3 ray = i % 2 == 0
                                 ? random.direction()
                                 : (s.surfaces.cone[bone].axis + 0.2 * random.direction()).normalized();
            const double exit = exit_of_joint(s.network, s.surfaces, joint, centre, ray),
                         reach = reach_of_joint(s.network, s.surfaces, joint, centre, ray);
            double most = exit;
            for (std::int32_t slot = s.network.slot_first[joint]; slot < s.network.slot_first[joint + 1];
                 ++slot)
                if (const double along = ray.dot(s.surfaces.cone[slot].axis); along > 0)
                    most = std::min(most, s.surfaces.limit[slot] / along);
            EXPECT_NEAR(reach, most, 1e-12);
            cut += reach < exit;
        }
    }
    EXPECT_GT(cut, 100);
}

TEST(JointReach, OfADentEndsAtItsFloor) {
    const Stages s(dented_ball(std::vector<double>{0}, 0.3, 0.2));
    property::Random random(32);
    int below = 0;
    for (int i = 0; i < 200; ++i) {
        const Vec3 ray = (Vec3::UnitZ() + 0.5 * random.direction()).normalized();
        const double exit = exit_of_joint(s.network, s.surfaces, 0, Vec3::Zero(), ray);
        EXPECT_LE(exit, 1 + 1e-12);
        const double size = s.surfaces.pits[0].local(exit * ray - s.surfaces.pits[0].middle).norm();
        if (exit < 1 - 1e-9) {
            EXPECT_NEAR(size, 1, 1e-9);
            ++below;
        } else {
            EXPECT_GE(size, 1 - 1e-6);
        }
    }
    EXPECT_GT(below, 30);
}

}  // namespace
}  // namespace sinew::sqm
