#include "sinew/sqm/cells/large_hull.h"

#include "sinew/sqm/cells/near_directions.h"
#include "sinew/sqm/cells/spherical_cells.h"
#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

/// All points are corners, each edge is that of two faces, and no face is below the point across its edge:
/// what is convex at every edge is so as a whole.
void expect_large_convex(const SphereHull& hull, std::size_t count) {
    ASSERT_EQ(hull.face_count(), 2 * std::ssize(hull.grid) - 4);
    ASSERT_EQ(hull.grid.size(), count);
    for (std::int32_t f = 0; f < hull.face_count(); ++f) {
        const auto face = hull.face(f);
        for (int k = 0; k < 3; ++k) {
            const std::int32_t beyond = hull.face_of(face[(k + 1) % 3], face[k]);
            ASSERT_GE(beyond, 0);
            for (const std::int32_t p : hull.face(beyond))
                EXPECT_LE(wide_orientation(hull.grid[face[0]], hull.grid[face[1]], hull.grid[face[2]],
                                           hull.grid[p]),
                          0);
        }
    }
}

TEST(LargeHull, IsConvexAndHasAllPoints) {
    property::Random random(1);
    SphereHull hull;
    for (const int n : {crowd + 1, 1000, 5000}) {
        const auto points = random_directions(random, n);
        find_sphere_hull(points, hull);
        expect_large_convex(hull, points.size());
    }
}

TEST(LargeHull, IsConvexForABundleAndForAWheelWithAnAxle) {
    property::Random random(2);
    std::vector<Vec3> bundle, wheel = fan(2000);
    for (int i = 0; i < 2000; ++i) bundle.push_back((Vec3::UnitX() + 0.1 * random.direction()).normalized());
    wheel.push_back(Vec3::UnitZ());
    wheel.push_back(-Vec3::UnitZ());
    SphereHull hull;
    find_sphere_hull(bundle, hull);
    expect_large_convex(hull, bundle.size());
    find_sphere_hull(wheel, hull);
    expect_large_convex(hull, wheel.size());
}

/// Every cell of a crowd is a ring of sides, wherever its directions are: Euler's formula for the whole.
TEST(LargeHull, MakesCellsOfAnyCrowd) {
    property::Random random(4);
    for (const double spread : {0.0, 1e-7, 1e-4, 0.1, 100.0}) {
        std::vector<Vec3> directions;
        for (int i = 0; i < 600; ++i)
            directions.push_back((Vec3::UnitX() + spread * random.direction()).normalized());
        SphericalCells cells;
        find_spherical_cells(directions, cells);
        EXPECT_EQ(std::ssize(cells.vertices) - std::ssize(cells.arcs) + cells.cell_count(), 2);
        for (std::int32_t c = 0; c < cells.cell_count(); ++c) EXPECT_GE(cells.cell(c).size(), 2u);
    }
}

/// More directions in one plane than can be kept the usual angle apart stay as they were drawn.
TEST(LargeHull, LeavesSpokesForWhichThereIsNoRoomInTheirPlaces) {
    for (const int count : {159, 240, 1000}) {
        const auto spokes = fan(count);
        SphericalCells cells;
        find_spherical_cells(spokes, cells);
        for (int i = 0; i < count; ++i) EXPECT_LT((cells.sites[i] - spokes[i]).norm(), 1e-6);
    }
}

}  // namespace
}  // namespace sinew::sqm
