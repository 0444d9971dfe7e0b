#include "document/images.h"

#include <gtest/gtest.h>

#include <numbers>

namespace sinew::modeler {
namespace {

using Kind = Symmetry::Kind;

TEST(Images, the_first_is_what_is_drawn) {
    for (const Symmetry& symmetry : {Symmetry{}, Symmetry{Kind::mirror, 1, 1}, Symmetry{Kind::radial, 0, 5}})
        EXPECT_TRUE(images_of(symmetry).front().isIdentity());
    EXPECT_EQ(images_of({}).size(), 1u);
}

TEST(Images, a_mirror_turns_one_coordinate_round) {
    for (int axis = 0; axis < 3; ++axis) {
        const std::vector<Mat3> images = images_of({Kind::mirror, axis, 1});
        ASSERT_EQ(images.size(), 2u);
        Vec3 expected(1, 2, 3);
        expected[axis] *= -1;
        EXPECT_TRUE((images[1] * Vec3(1, 2, 3)).isApprox(expected));
    }
}

TEST(Images, rotations_are_those_of_the_circle) {
    const std::vector<Mat3> images = images_of({Kind::radial, 2, 8});
    ASSERT_EQ(images.size(), 8u);
    for (int k = 0; k < 8; ++k) {
        const double angle = 2 * std::numbers::pi * k / 8;
        EXPECT_TRUE((images[k] * Vec3(1, 0, 5)).isApprox(Vec3(std::cos(angle), std::sin(angle), 5)));
        EXPECT_NEAR(images[k].determinant(), 1, 1e-12);
    }
}

TEST(Images, what_they_share_is_its_own_twin) {
    const Symmetry mirror{Kind::mirror, 1, 1}, radial{Kind::radial, 0, 6};
    const Vec3 point(1, 2, 3);
    EXPECT_EQ(onto_symmetry(mirror, point), Vec3(1, 0, 3));
    EXPECT_EQ(onto_symmetry(radial, point), Vec3(1, 0, 0));
    EXPECT_EQ(onto_symmetry({}, point), point);
    for (const Symmetry& symmetry : {mirror, radial}) {
        EXPECT_FALSE(is_own_twin(symmetry, point, 1));
        const Vec3 shared = onto_symmetry(symmetry, point);
        EXPECT_TRUE(is_own_twin(symmetry, shared, 1));
        for (const Mat3& image : images_of(symmetry)) EXPECT_TRUE((image * shared).isApprox(shared));
    }
}

TEST(Images, are_told_in_words) {
    EXPECT_EQ(describe({}), "no symmetry");
    EXPECT_EQ(describe({Kind::mirror, 2, 1}), "mirror z");
    EXPECT_EQ(describe({Kind::radial, 1, 8}), "radial y, 8");
}

}  // namespace
}  // namespace sinew::modeler
