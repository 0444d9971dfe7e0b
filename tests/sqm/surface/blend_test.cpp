#include "sinew/sqm/surface/blend.h"

#include "sinew/sqm/surface/joint_reach.h"
#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

/// Tubes of radius 0.5 along -x, x and y, blended by a ball of `blend` radii.
Stages tee(double blend) {
    Plain plain = plain_of(star(std::vector<Vec3>{-Vec3::UnitX(), Vec3::UnitX(), Vec3::UnitY()}, 8, 0.5));
    plain.blend.assign(plain.position.size(), blend);
    return Stages(std::move(plain));
}

double exit_of(const Stages& s, const Vec3& ray) {
    return exit_of_joint(s.network, s.surfaces, 0, Vec3::Zero(), ray.normalized());
}

TEST(Blend, LeavesAQuarterOfACylinderWhereTubesMeetAtRightAngles) {
    for (const double blend : {0.25, 0.5, 1.0}) {
        const Stages s = tee(blend);
        // The ball touches both tubes where both are as far from the crotch as it is large.
        const double along_both = 0.5 + 0.5 * blend * (1 - std::sqrt(0.5));
        EXPECT_NEAR(exit_of(s, {1, 1, 0}), std::sqrt(2.0) * along_both, 1e-3) << blend;
        const Vec3 on_fillet(along_both, along_both, 0), in_free(2, 2, 0);
        EXPECT_NEAR(blended_distance(s.network, s.surfaces, 0, on_fillet), 0, 1e-9);
        EXPECT_NEAR(blended_distance(s.network, s.surfaces, 0, in_free), 1.5, 1e-9);
    }
}

TEST(Blend, LeavesConvexPlacesAsTheyAre) {
    const Stages plain = tee(0), blended = tee(1);
    for (const Vec3& ray : {Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(1, -1, 0), Vec3(0.2, -1, 1)})
        EXPECT_EQ(exit_of(blended, ray), exit_of(plain, ray));
}

TEST(Blend, OfNoRadiusIsTheUnionOfTheCones) {
    property::Random random(41);
    const Stages s = tee(0);
    for (int i = 0; i < 100; ++i) {
        const Vec3 place = random.direction() * random.between(0.1, 3);
        double nearest = 1e300;
        for (const ConeFrom& cone : s.surfaces.cone) nearest = std::min(nearest, cone.distance(place));
        EXPECT_EQ(blended_distance(s.network, s.surfaces, 0, place), nearest);
    }
}

TEST(Blend, OnlyAddsAndNoMoreThanTheBall) {
    property::Random random(42);
    for (int degree = 3; degree < 9; ++degree) {
        Plain plain = plain_of(star(random_directions(random, degree), 6, 0.5));
        plain.blend.assign(plain.position.size(), 0.5);
        const Stages s(std::move(plain));
        for (int i = 0; i < 100; ++i) {
            const Vec3 place = random.direction() * random.between(0.1, 3);
            double nearest = 1e300;
            for (const ConeFrom& cone : s.surfaces.cone) nearest = std::min(nearest, cone.distance(place));
            const double blended = blended_distance(s.network, s.surfaces, 0, place);
            EXPECT_LE(blended, nearest);
            if (nearest >= 0.25) {
                EXPECT_EQ(blended, nearest);  // the ball fits between this place and the cones
            }
        }
    }
}

}  // namespace
}  // namespace sinew::sqm
