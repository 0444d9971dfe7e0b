#include "sinew/sqm/cells/sphere_hull.h"

#include <set>

#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

/// No point lies above a face, on the grid where signs are exact; edges are those of two faces.
void expect_convex(const SphereHull& hull, std::size_t count) {
    const auto n = static_cast<std::int32_t>(count);
    for (std::int32_t f = 0; f < hull.face_count(); ++f) {
        const auto face = hull.face(f);
        const auto &a = hull.grid[face[0]], &b = hull.grid[face[1]], &c = hull.grid[face[2]];
        for (std::int32_t i = 0; i < n; ++i) EXPECT_LE((b - a).cross(c - a).dot(hull.grid[i] - a), 0);
        for (std::size_t k = 0; k < face.size(); ++k) {
            const std::int32_t u = face[k], v = face[(k + 1) % face.size()];
            EXPECT_EQ(hull.face_of(u, v), f);
            EXPECT_GE(hull.face_of(v, u), 0);
        }
    }
}
/// Points that are corners of some face.
std::size_t points_used(const SphereHull& hull) {
    return std::set<std::int32_t>(hull.corner.begin(), hull.corner.end()).size();
}

TEST(SphereHull, OfPointsInGeneralPositionHasAllOfThemAndTrianglesByEuler) {
    property::Random random(1);
    SphereHull hull;
    for (int n = 4; n <= 40; ++n) {
        find_sphere_hull(random_directions(random, n), hull);
        expect_convex(hull, n);
        EXPECT_EQ(points_used(hull), std::size_t(n));
        EXPECT_EQ(hull.face_count(), 2 * n - 4);
    }
}

TEST(SphereHull, OfACubesCornersHasTwoTrianglesASide) {
    const std::vector<Vec3> corners = cube_corners();
    SphereHull hull;
    find_sphere_hull(corners, hull);
    expect_convex(hull, 8);
    EXPECT_EQ(hull.face_count(), 12);
    EXPECT_EQ(points_used(hull), 8u);
}

TEST(SphereHull, OfPointsInAPlaneHasTwoFacesBackToBack) {
    for (const double height : {0.0, 0.5, -0.9})
        for (const int n : {3, 4, 7}) {
            std::vector<Vec3> points = fan(n);
            for (Vec3& p : points) p = std::sqrt(1 - height * height) * p + height * Vec3::UnitZ();
            std::swap(points[0], points[n - 1]);
            SphereHull hull;
            find_sphere_hull(points, hull);
            ASSERT_EQ(hull.face_count(), 2);
            EXPECT_EQ(points_used(hull), std::size_t(n));
            for (int f = 0; f < 2; ++f)
                for (std::size_t k = 0; k < hull.face(f).size(); ++k) {
                    const std::int32_t u = hull.face(f)[k], v = hull.face(f)[(k + 1) % n];
                    EXPECT_NEAR((points[u] - points[v]).norm(), (points[0] - points[n - 1]).norm(), 1e-9);
                    EXPECT_EQ(hull.face_of(u, v), f);
                    EXPECT_EQ(hull.face_of(v, u), 1 - f);
                }
        }
}

TEST(SphereHull, OfADirectionAndItsOppositeAmongOthersIsConvex) {
    const std::vector<Vec3> points{Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(),
                                   -Vec3::UnitZ()};
    SphereHull hull;
    find_sphere_hull(points, hull);
    expect_convex(hull, points.size());
    EXPECT_EQ(points_used(hull), 5u);
}

TEST(SphereHull, OfABundleInOneHalfSpaceIsConvex) {
    property::Random random(2);
    SphereHull hull;
    for (int n = 4; n <= 12; ++n) {
        std::vector<Vec3> points = random_directions(random, n);
        for (Vec3& p : points) p = (0.2 * p + Vec3(1, 2, 3).normalized()).normalized();
        find_sphere_hull(points, hull);
        expect_convex(hull, n);
        EXPECT_EQ(points_used(hull), std::size_t(n));
    }
}

}  // namespace
}  // namespace sinew::sqm
