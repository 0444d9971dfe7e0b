#include "sinew/render/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace sinew {
namespace {

/// Where a point is in the picture: x and y in -1..1, z in -1..1 from the near to the far plane.
Vec3f project(const Camera& camera, double aspect, const Bounds& bounds, const Vec3f& point) {
    const Eigen::Vector4f clip =
        projection_matrix(camera, aspect, bounds) * view_matrix(camera) * point.homogeneous();
    return clip.head<3>() / clip.w();
}

std::vector<Vec3f> scattered_points(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> x(-3, 5);
    std::vector<Vec3f> points;
    for (int i = 0; i < 40; ++i) points.emplace_back(10 + x(random), x(random) * 0.2f, x(random) * 2);
    return points;
}

Bounds bounds_of(const std::vector<Vec3f>& points) {
    Bounds bounds;
    for (const Vec3f& p : points) bounds.extend(p);
    return bounds;
}

TEST(Camera, FitsPointsAsLargeAsTheyCanBe) {
    const std::vector<Vec3f> points = scattered_points(7);
    for (const View view : {View::front, View::side, View::top, View::iso})
        for (const double aspect : {0.5, 1.0, 2.5}) {
            const Camera camera = fit(camera_of(view), points, aspect, 0.1);
            float reach = 0;
            for (const Vec3f& p : points) {
                const Vec3f at = project(camera, aspect, bounds_of(points), p);
                reach = std::max({reach, std::abs(at.x()), std::abs(at.y())});
            }
            EXPECT_NEAR(reach, 0.8f, 1e-4f) << "view " << int(view) << ", aspect " << aspect;
        }
}

TEST(Camera, DepthRangeEnclosesTheBounds) {
    const std::vector<Vec3f> points = scattered_points(8);
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        Camera camera = camera_of(View::iso);
        camera.projection = projection;
        camera = fit(camera, points, 1.5);
        for (const Vec3f& p : points) EXPECT_LE(std::abs(project(camera, 1.5, bounds_of(points), p).z()), 1);
    }
}

TEST(Camera, ViewsLookAlongTheAxes) {
    const auto on_screen = [](View view, const Vec3f& p) {
        return Vec3f((view_matrix(camera_of(view)) * p.homogeneous()).head<3>() -
                     (view_matrix(camera_of(view)) * Vec3f::Zero().eval().homogeneous()).head<3>());
    };
    EXPECT_TRUE(on_screen(View::front, Vec3f::UnitX()).isApprox(Vec3f(1, 0, 0)));
    EXPECT_TRUE(on_screen(View::front, Vec3f::UnitZ()).isApprox(Vec3f(0, 1, 0)));
    EXPECT_TRUE(on_screen(View::front, -Vec3f::UnitY()).isApprox(Vec3f(0, 0, 1))) << "models face -y";
    EXPECT_TRUE(on_screen(View::side, Vec3f::UnitY()).isApprox(Vec3f(1, 0, 0)));
    EXPECT_TRUE(on_screen(View::side, Vec3f::UnitZ()).isApprox(Vec3f(0, 1, 0)));
    EXPECT_TRUE(on_screen(View::top, Vec3f::UnitX()).isApprox(Vec3f(1, 0, 0)));
    EXPECT_TRUE(on_screen(View::top, Vec3f::UnitY()).isApprox(Vec3f(0, 1, 0)));
}

TEST(Camera, OrbitKeepsTargetAndDistanceAndStopsAtTheZenith) {
    Camera camera = camera_of(View::iso);
    camera.target = {1, 2, 3};
    const Camera turned = orbit(camera, 400, 200);
    EXPECT_EQ(turned.elevation, 90);
    EXPECT_NEAR((eye_of(turned) - camera.target).norm(), camera.distance, 1e-12);
    EXPECT_NEAR(std::remainder(turned.azimuth - camera.azimuth - 40, 360), 0, 1e-9);
}

TEST(Camera, PanMovesThePictureByShares) {
    const Camera camera = camera_of(View::front), moved = pan(camera, 0.5, -0.25);
    const Bounds bounds(Vec3f(-1, -1, -1), Vec3f(1, 1, 1));
    const Vec3f at = project(moved, 1, bounds, Vec3f::Zero());
    EXPECT_NEAR(at.x(), -1, 1e-6);  // half the height is one of the two units from edge to edge
    EXPECT_NEAR(at.y(), 0.5, 1e-6);
}

TEST(Camera, NothingToFitLeavesItAsItIs) {
    const Camera camera = fit(camera_of(View::iso), Bounds(), 1);
    EXPECT_EQ(camera.distance, camera_of(View::iso).distance);
    EXPECT_EQ(camera.target, camera_of(View::iso).target);
}

}  // namespace
}  // namespace sinew
