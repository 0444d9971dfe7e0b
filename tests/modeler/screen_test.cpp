#include "document/screen.h"

#include <gtest/gtest.h>

#include "stage.h"

namespace sinew::modeler {
namespace {

TEST(Screen, a_point_lies_on_the_ray_through_its_pixel) {
    for (const Screen& screen : {front_screen(), perspective_screen()})
        for (const Vec3& point : {Vec3(0, 0, 0), Vec3(1, 2, -1), Vec3(-2, 5, 0.5)}) {
            const Ray ray = screen.ray(*screen.project(point));
            EXPECT_LT((point - ray.origin).cross(ray.direction).norm(), 1e-9);
            EXPECT_NEAR(ray.direction.norm(), 1, 1e-12);
            EXPECT_GT(ray.direction.y(), 0.5);
        }
}

TEST(Screen, knows_its_directions_and_lengths) {
    const Screen screen = front_screen();
    EXPECT_TRUE(screen.forward(Vec3::Zero()).isApprox(Vec3::UnitY()));
    EXPECT_TRUE(screen.right(Vec3(1, 1, 1)).isApprox(Vec3::UnitX()));
    EXPECT_TRUE(screen.up(Vec3(1, 1, 1)).isApprox(Vec3::UnitZ()));
    EXPECT_NEAR(screen.pixel_length(Vec3(3, 4, 5)), 0.01, 1e-12);
    EXPECT_NEAR(perspective_screen().pixel_length(Vec3::Zero()), 0.01, 1e-6);
    EXPECT_NEAR(perspective_screen().pixel_length(Vec3(0, 10, 0)), 0.02, 1e-6);
}

TEST(Screen, what_is_behind_the_camera_has_no_pixel) {
    EXPECT_FALSE(perspective_screen().project(Vec3(0, -11, 0)));
}

TEST(Screen, in_an_image_things_are_where_the_image_shows_them) {
    Mat3 mirror = Mat3::Identity();
    mirror(0, 0) = -1;
    const Screen screen = perspective_screen();
    EXPECT_TRUE(screen.in_image(mirror).project(Vec3(1, 2, 3))->isApprox(*screen.project(Vec3(-1, 2, 3))));
}

TEST(Screen, rays_meet_planes_and_lines) {
    const Ray ray{Vec3(0, -10, 0), Vec3(0, 1, 0)};
    EXPECT_TRUE(meet_plane(ray, Vec3(5, 2, 5), Vec3::UnitY())->isApprox(Vec3(0, 2, 0)));
    EXPECT_FALSE(meet_plane(ray, Vec3(0, 0, 1), Vec3::UnitZ()));
    EXPECT_FALSE(meet_plane(ray, Vec3(0, -20, 0), Vec3::UnitY()));
    EXPECT_TRUE(nearest_on_line(ray, Vec3(3, 0, 1), Vec3(2, 0, 0))->isApprox(Vec3(0, 0, 1)));
    EXPECT_TRUE(nearest_on_line(ray, Vec3(3, 5, 0), Vec3(1, 1, 0))->isApprox(Vec3(0, 2, 0)));
    EXPECT_FALSE(nearest_on_line(ray, Vec3(3, 0, 1), Vec3(0, 1, 0)));
}

}  // namespace
}  // namespace sinew::modeler
