#include "sinew/base/round_cone.h"

#include <gtest/gtest.h>

#include "property/random.h"

namespace sinew {
namespace {

/// Signed distance from the hull of the two balls, from its definition: the best ball between them.
double distance(const Vec3& point, double near, const Vec3& to, double far) {
    double best = 1e300;
    for (int i = 0; i <= 20000; ++i) {
        const double share = i / 20000.0;
        best = std::min(best, (point - share * to).norm() - (near + share * (far - near)));
    }
    return best;
}

TEST(RoundCone, RaysLeaveItOnItsSurface) {
    property::Random random(1);
    for (int i = 0; i < 60; ++i) {
        const Vec3 to = random.between(0.5, 4) * random.direction();
        const double near = random.between(0.2, 1), far = random.between(0.2, 1);
        const ConeFrom cone(Vec3::Zero(), near, to, far);
        const Vec3 ray = random.direction();
        EXPECT_NEAR(distance(cone.exit(ray) * ray, near, to, far), 0, 2e-4);
    }
}

TEST(RoundCone, DistanceIsThatFromTheBallsBetweenItsEnds) {
    property::Random random(3);
    for (int i = 0; i < 60; ++i) {  // some are balls within balls
        const Vec3 to = random.between(0.1, 4) * random.direction();
        const double near = random.between(0.2, 1), far = random.between(0.2, 2);
        const ConeFrom cone(Vec3::Zero(), near, to, far);
        const Vec3 point = random.between(0, 6) * random.direction();
        EXPECT_NEAR(cone.distance(point), distance(point, near, to, far), 1e-4);
        EXPECT_EQ(cone.holds(point), cone.distance(point) <= 0);
    }
}

TEST(RoundCone, HoldsARayUpToWhereThatLeavesIt) {
    property::Random random(2);
    for (int i = 0; i < 2000; ++i) {  // some are balls within balls
        const ConeFrom cone(Vec3::Zero(), random.between(0.2, 1), random.between(0.5, 4) * random.direction(),
                            random.between(0.2, 2));
        const Vec3 ray = random.direction();
        EXPECT_TRUE(cone.holds(0.999 * cone.exit(ray) * ray));
        EXPECT_FALSE(cone.holds(1.001 * cone.exit(ray) * ray));
    }
}

TEST(RoundCone, OfEqualBallsIsACylinderWithCaps) {
    const ConeFrom cone(Vec3::Zero(), 1, {0, 0, 5}, 1);
    EXPECT_DOUBLE_EQ(cone.exit(Vec3::UnitX()), 1);
    EXPECT_DOUBLE_EQ(cone.exit(Vec3::UnitZ()), 6);
    EXPECT_DOUBLE_EQ(cone.exit(-Vec3::UnitZ()), 1);
    EXPECT_DOUBLE_EQ(cone.radius_at(2.5), 1);
    EXPECT_DOUBLE_EQ(cone.radius_at(5.6), 0.8);
    EXPECT_DOUBLE_EQ(cone.side_begin(), 0);
    EXPECT_DOUBLE_EQ(cone.side_end(), 5);
}

TEST(RoundCone, OfANestedBallIsTheLargerOne) {
    const ConeFrom inside(Vec3::Zero(), 2, {0.5, 0, 0}, 1), outside(Vec3::Zero(), 1, {0.5, 0, 0}, 2);
    EXPECT_TRUE(inside.nested());
    property::Random random(2);
    for (int i = 0; i < 20; ++i) {
        const Vec3 ray = random.direction();
        EXPECT_DOUBLE_EQ(inside.exit(ray), 2);
        EXPECT_NEAR((outside.exit(ray) * ray - Vec3(0.5, 0, 0)).norm(), 2, 1e-12);
    }
}

TEST(RoundCone, SideMeetsBothBallsSmoothly) {
    const ConeFrom cone(Vec3::Zero(), 2, {0, 0, 4}, 1);
    for (const double height : {cone.side_begin(), cone.side_end()})
        EXPECT_NEAR(cone.radius_at(height - 1e-9), cone.radius_at(height + 1e-9), 1e-8);
    EXPECT_EQ(cone.radius_at(-2.1), 0);
    EXPECT_EQ(cone.radius_at(5.1), 0);
}

}  // namespace
}  // namespace sinew
