#include "sinew/skeleton/symmetric_frame.h"

#include <gtest/gtest.h>

#include "property/random.h"
#include "sinew/skeleton/symmetry.h"

namespace sinew {
namespace {

const Symmetry mirror{Symmetry::Kind::mirror, 1, 2}, half_turn{Symmetry::Kind::radial, 0, 2},
    quarter{Symmetry::Kind::radial, 2, 4}, third{Symmetry::Kind::radial, 2, 3};

/// The points of a box that is turned so; which corner is which does not count.
Mat3 inertia(const Mat3& frame, const Vec3& extents) {
    return frame * extents.cwiseAbs2().asDiagonal() * frame.transpose();
}
bool is_its_own_image(const Mat3& frame, const Vec3& extents, const Symmetry& symmetry) {
    const Mat3 turn = symmetry_transform(symmetry, 1), shape = inertia(frame, extents);
    return (turn * shape * turn.transpose() - shape).norm() < 1e-9 * shape.norm();
}

TEST(SymmetricFrame, MakesTheShapeItsOwnImage) {
    property::Random random(31);
    for (int i = 0; i < 200; ++i) {
        const Mat3 drawn =
            Quat(Eigen::AngleAxisd(random.between(-3, 3), random.direction())).toRotationMatrix();
        const Vec3 flat(1, random.between(0.3, 3), random.between(0.3, 3)), square(1.5, 0.4, 1.5);
        for (const Symmetry& symmetry : {mirror, half_turn})
            for (const Vec3& extents : {flat, square}) {
                const Mat3 frame = symmetric_frame(drawn, extents, symmetry, false);
                EXPECT_TRUE(is_its_own_image(frame, extents, symmetry));
                EXPECT_EQ(symmetric_frame(frame, extents, symmetry, false), frame);  // is so already
                EXPECT_NEAR(frame.determinant(), 1, 1e-9);
            }
        for (const Symmetry& symmetry : {quarter, third})
            EXPECT_TRUE(is_its_own_image(symmetric_frame(drawn, square, symmetry, false), square, symmetry));
    }
}

TEST(SymmetricFrame, TakesTheNearest) {
    const auto turned = [](double degrees) {
        return Mat3(Quat(Eigen::AngleAxisd(degrees * M_PI / 180, Vec3::UnitX())).toRotationMatrix());
    };
    const Vec3 cube = Vec3::Ones();
    EXPECT_TRUE(symmetric_frame(turned(10), cube, mirror, false).isApprox(turned(0), 1e-12));
    EXPECT_TRUE(symmetric_frame(turned(40), cube, mirror, false).isApprox(turned(0), 1e-12));
    EXPECT_TRUE(symmetric_frame(turned(45), cube, mirror, false).isApprox(turned(45), 1e-12));  // as drawn
    const Symmetry sideways{Symmetry::Kind::mirror, 0, 2};
    const auto rolled = [](double degrees) {
        return Mat3(Quat(Eigen::AngleAxisd(degrees * M_PI / 180, Vec3::UnitZ())).toRotationMatrix());
    };
    EXPECT_TRUE(symmetric_frame(rolled(40), cube, sideways, true).isApprox(rolled(45), 1e-12));
    EXPECT_TRUE(symmetric_frame(rolled(40), {1, 2, 3}, sideways, true).isApprox(rolled(0), 1e-12));
}

TEST(SymmetricFrame, OnlyRollsWhatBonesHold) {
    const Mat3 drawn = Quat(Eigen::AngleAxisd(0.3, Vec3::UnitX())).toRotationMatrix();  // x in the plane
    Mat3 upright;  // z along the world's X, in the plane
    upright << drawn.col(1), drawn.col(2), drawn.col(0);
    const Mat3 frame = symmetric_frame(upright, {1, 2, 0}, mirror, true);
    EXPECT_TRUE(frame.col(2).isApprox(upright.col(2), 1e-12));
    EXPECT_TRUE(is_its_own_image(frame, {1, 2, 0}, mirror));
}

TEST(SymmetricFrame, DoesNotLeaveTheWayOfASectionOnTheMirrorsNormal) {
    const Mat3 frame = symmetric_frame(Mat3::Identity(), {1, 2, 0}, {Symmetry::Kind::mirror, 2, 2}, false);
    EXPECT_NEAR(frame.col(2).z(), 0, 1e-12);
}

TEST(SymmetricFrame, LeavesWhatCannotBeSymmetric) {
    const Mat3 drawn = Quat(Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized())).toRotationMatrix();
    EXPECT_EQ(symmetric_frame(drawn, {1, 2, 3}, quarter, false), drawn);
}

}  // namespace
}  // namespace sinew
