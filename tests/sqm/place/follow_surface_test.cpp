#include "sinew/sqm/place/follow_surface.h"

#include "sinew/sqm/surface/dents.h"
#include "sinew/sqm/surface/joint_reach.h"
#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

TEST(FollowSurface, DividesTheGreatCircleAndLiesOnTheJoint) {
    property::Random random(33);
    const Stages s(star(random_directions(random, 5), 5, 0.5));
    for (int i = 0; i < 50; ++i) {
        const Vec3 a = random.between(0.5, 2) * random.direction(),
                   b = random.between(0.5, 2) * random.direction();
        const double share = random.unit(), whole = angle_between(a, b);
        const Vec3 at = follow_surface(s.parts(), {0, 0}, a, b, share);
        EXPECT_NEAR(at.norm(), reach_of_joint(s.network, s.surfaces, 0, Vec3::Zero(), at.normalized()), 1e-9);
        EXPECT_NEAR(angle_between(a, at), share * whole, 1e-7);
        EXPECT_NEAR(angle_between(at, b), (1 - share) * whole, 1e-7);
    }
}

TEST(FollowSurface, GoesStraightWhereThereIsNoGreatCircle) {
    const Stages s(star(fan(4), 5, 0.5));
    for (const Vec3& from : {Vec3(1, 0, 0), Vec3(0.6, -0.8, 0.1)})
        for (const double to : {2.0, 0.7, -1.0, -3.0})
            for (const double share : {0.0, 0.25, 0.5, 1.0})
                EXPECT_TRUE(follow_surface(s.parts(), {0, 0}, from, to * from, share)
                                .isApprox((1 - share + share * to) * from, 1e-12) ||
                            1 - share + share * to == 0);
}

/// Two dents that overlap: between two places on the rim of their groove there is a third one.
TEST(FollowSurface, StaysOnTheRimOfAGroove) {
    const Stages s(dented_ball(std::vector<double>{-0.2, 0.2}, 0.3, 0.2));
    ASSERT_TRUE(has_groove(s.surfaces, 0));
    for (std::int32_t slot = 0; slot < s.network.degree(0); ++slot) {
        if (s.surfaces.kind[slot] != SlotKind::pit) continue;
        const PitShape& pit = s.surfaces.pits[s.surfaces.extra[slot]];
        const auto rim = [&](double angle) {
            const Vec3 side = std::cos(angle) * pit.x + std::sin(angle) * pit.y;
            return rim_towards(s.network, s.surfaces, 0, pit, Vec3::Zero(),
                               (pit.z + 0.1 * side).normalized());
        };
        for (double angle = 0; angle < 6; angle += 0.5) {
            const Vec3 at = follow_surface(s.parts(), {0, slot}, rim(angle), rim(angle + 0.6), 0.5);
            EXPECT_NEAR(at.norm(), 1, 1e-9);
            EXPECT_TRUE(on_rim(s.network, s.surfaces, 0, Vec3::Zero(), at));
        }
    }
}

}  // namespace
}  // namespace sinew::sqm
