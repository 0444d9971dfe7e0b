#include "sinew/sqm/bridge/lone_sphere.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>

#include "sinew/base/vec.h"

namespace sinew::sqm {
namespace {

TEST(LoneSphere, PointsAreThoseOfACube) {
    const std::set<std::array<int, 3>> points(lone_sphere_points().begin(), lone_sphere_points().end());
    EXPECT_EQ(points.size(), 26u);
    EXPECT_EQ(points.count({0, 0, 0}), 0u);
    for (const std::array<int, 3>& point : points)
        for (const int coordinate : point) EXPECT_LE(std::abs(coordinate), 1);
}

TEST(LoneSphere, IsClosedAndLooksOutward) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    double volume = 0;
    for (const auto& face : lone_sphere_faces()) {
        std::array<Vec3, 4> at;
        for (int k = 0; k < 4; ++k) {
            const auto& point = lone_sphere_points()[face[k]];
            at[k] = Vec3(point[0], point[1], point[2]);
            ++edges[{face[k], face[(k + 1) % 4]}];
        }
        volume += (at[0].dot(at[1].cross(at[2])) + at[0].dot(at[2].cross(at[3]))) / 6;
    }
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
    }
    EXPECT_NEAR(volume, 8, 1e-12);
}

TEST(LoneSphere, HasFourFacesASide) {
    for (int side = 0; side < 6; ++side)
        for (int i = 0; i < 4; ++i)
            for (const std::uint32_t v : lone_sphere_faces()[4 * side + i])
                EXPECT_EQ(lone_sphere_points()[v][side / 2], side % 2 == 0 ? -1 : 1);
}

}  // namespace
}  // namespace sinew::sqm
