#include "document/snap.h"

#include <gtest/gtest.h>

#include <numbers>

#include "stage.h"

namespace sinew::modeler {
namespace {

TEST(Snap, the_grid_has_round_steps_that_can_be_told_apart) {
    EXPECT_DOUBLE_EQ(grid_step(front_screen(), Vec3::Zero()), 0.2);  // 12 pixels are 0.12
    for (double zoom : {1e-4, 3e-2, 7.0, 1e5}) {
        Eigen::Matrix4d m = front_screen().world_to_clip();
        m.topLeftCorner<3, 3>() *= zoom;
        const Screen screen(m, {800, 600});
        const double step = grid_step(screen, Vec3::Zero());
        EXPECT_GE(step / screen.pixel_length(Vec3::Zero()), 12 - 1e-9);
        EXPECT_LE(step / screen.pixel_length(Vec3::Zero()), 30 + 1e-9);
    }
    EXPECT_TRUE(onto_grid(Vec3(0.31, -0.29, 0), 0.2).isApprox(Vec3(0.4, -0.2, 0)));
}

TEST(Snap, angles_are_multiples_of_fifteen_degrees_at_the_same_distance) {
    const Vec3 pivot(1, 0, 1);
    for (double angle : {3.0, 40.0, 100.0, -50.0, 179.0}) {
        const double a = angle * std::numbers::pi / 180;
        const Vec3 turned = onto_angle(pivot + 2 * Vec3(std::cos(a), 0, std::sin(a)), pivot, Vec3::UnitY());
        EXPECT_NEAR((turned - pivot).norm(), 2, 1e-12);
        const double degrees =
            std::atan2(turned.z() - pivot.z(), turned.x() - pivot.x()) * 180 / std::numbers::pi;
        EXPECT_NEAR(std::remainder(degrees, 15), 0, 1e-9);
        EXPECT_LE(std::abs(std::remainder(degrees - angle, 360)), 7.5 + 1e-9);
    }
}

TEST(Snap, nodes_catch_within_reach_only) {
    Document document = plain_document();
    append_node(document, {.id = -1, .parent = 0, .position = Vec3(2, 0, 0)});
    const std::vector<std::int32_t> moving{1};
    EXPECT_EQ(*node_near(document, moving, front_screen(), Vec3(0.1, 5, 0)), Vec3(0, 0, 0));
    EXPECT_FALSE(node_near(document, moving, front_screen(), Vec3(0.2, 0, 0)));
    EXPECT_FALSE(node_near(document, moving, front_screen(), Vec3(2, 0, 0)));  // itself
}

TEST(Snap, the_mirror_catches_what_comes_near) {
    const Symmetry mirror{Symmetry::Kind::mirror, 0, 1};
    const Snapped near = onto_near_symmetry(mirror, front_screen(), Vec3(0.05, 1, 2));
    EXPECT_TRUE(near.caught);
    EXPECT_EQ(near.position, Vec3(0, 1, 2));
    EXPECT_FALSE(onto_near_symmetry(mirror, front_screen(), Vec3(0.2, 1, 2)).caught);
    EXPECT_FALSE(onto_near_symmetry({}, front_screen(), Vec3(0, 1, 2)).caught);
}

}  // namespace
}  // namespace sinew::modeler
