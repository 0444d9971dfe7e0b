#include "sinew/extend/form.h"

#include <gtest/gtest.h>

namespace sinew {
namespace {

const Vec3 rays[] = {Vec3(1, 0, 0),
                     Vec3(0, -1, 0),
                     Vec3(0, 0, 1),
                     Vec3(1, 2, 3).normalized(),
                     Vec3(-3, 1, 2).normalized(),
                     Vec3(0.1, -2, -0.4).normalized()};

Form turned(Form::Kind kind, const Vec3& half) {
    const Mat3 axes = (Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized())).toRotationMatrix();
    Form form;
    form.kind = kind;
    form.x = axes.col(0), form.y = axes.col(1), form.z = axes.col(2);
    form.half = half;
    return form;
}

TEST(Form, RaysLeaveAnEllipsoidOnIt) {
    const Form form = turned(Form::Kind::ball, {1, 2, 5});
    for (const Vec3& ray : rays) EXPECT_NEAR(form.local(exit_of_ellipsoid(form, ray) * ray).norm(), 1, 1e-12);
    EXPECT_NEAR(exit_of_ellipsoid(form, form.y), 2, 1e-12);
    EXPECT_NEAR(exit_of_ellipsoid(form, -form.z), 5, 1e-12);
}

TEST(Form, RaysLeaveABoxThroughTheFaceThatTheyComeToFirst) {
    const Form form = turned(Form::Kind::box, {1, 2, 5});
    for (const Vec3& ray : rays)
        EXPECT_NEAR(form.local(exit_of_box(form, ray) * ray).cwiseAbs().maxCoeff(), 1, 1e-12);
    const Vec3 corner = form.x + 2 * form.y - 5 * form.z;
    EXPECT_NEAR(exit_of_box(form, corner.normalized()), corner.norm(), 1e-12);
    EXPECT_NEAR(exit_of_box(form, (form.x + form.y).normalized()), std::sqrt(2.0), 1e-12)
        << "by x, the nearer";
}

TEST(Form, OnlyBallsOfUnequalExtentsAreEllipsoids) {
    for (const Vec3& half : {Vec3(2, 1, 1), Vec3(1, 2, 1), Vec3(1, 1, 2)}) {
        const Form ball = turned(Form::Kind::ball, half), box = turned(Form::Kind::box, half);
        EXPECT_TRUE(is_ellipsoid(&ball));
        EXPECT_FALSE(is_ellipsoid(&box));
    }
    const Form round = turned(Form::Kind::ball, {3, 3, 3});
    EXPECT_FALSE(is_ellipsoid(&round));
    EXPECT_FALSE(is_ellipsoid(nullptr));
}

TEST(BallSpace, LeadsThereAndBack) {
    const Form form = turned(Form::Kind::ball, {1, 2, 5});
    for (const Vec3& ray : rays) {
        const Vec3 there = to_ball_space(&form, ray);
        EXPECT_NEAR(there.norm(), 1, 1e-12);
        EXPECT_LT((from_ball_space(&form, there) - ray).norm(), 1e-12);
        // The point of the ellipsoid in that direction is the point of the unit ball there.
        const Vec3 point = form.local(exit_of_ellipsoid(form, ray) * ray);
        EXPECT_LT((point.x() * form.x + point.y() * form.y + point.z() * form.z - there).norm(), 1e-12);
    }
}

TEST(BallSpace, KeepsGreatCircles) {
    const Form form = turned(Form::Kind::ball, {1, 2, 5});
    for (std::size_t i = 1; i < std::size(rays); ++i) {
        const Vec3 a = rays[i - 1], b = rays[i], between = (a + 0.3 * b).normalized();
        const Vec3 plane = from_ball_space(&form, a).cross(from_ball_space(&form, b));
        EXPECT_NEAR(from_ball_space(&form, between).dot(plane), 0, 1e-12);
    }
}

TEST(BallSpace, OfWhatIsNoEllipsoidChangesNothing) {
    const Form box = turned(Form::Kind::box, {1, 2, 5}), round = turned(Form::Kind::ball, {3, 3, 3});
    for (const Form* form : {static_cast<const Form*>(nullptr), &box, &round})
        for (const Vec3& ray : rays) {
            EXPECT_EQ(to_ball_space(form, ray), ray);
            EXPECT_EQ(from_ball_space(form, ray), ray);
        }
}

}  // namespace
}  // namespace sinew
