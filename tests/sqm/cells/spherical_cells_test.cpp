#include "sinew/sqm/cells/spherical_cells.h"

#include <algorithm>
#include <numeric>

#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

std::vector<int> cells_at_vertices(const SphericalCells& cells) {
    std::vector<int> count(cells.vertices.size(), 0);
    for (const CellArc& arc : cells.arcs) ++count[arc.from], ++count[arc.to];
    return count;
}

/// Sides of a cell follow each other, every arc has a cell on either side, and all is one sphere.
void expect_tiling(const SphericalCells& cells) {
    std::vector<int> left(cells.arcs.size(), 0), right(cells.arcs.size(), 0);
    for (std::int32_t c = 0; c < cells.cell_count(); ++c) {
        const auto sides = cells.cell(c);
        EXPECT_GE(sides.size(), 2u);
        for (std::size_t k = 0; k < sides.size(); ++k) {
            const CellArc &arc = cells.arcs[sides[k].arc],
                          &next = cells.arcs[sides[(k + 1) % sides.size()].arc];
            const bool next_reversed = sides[(k + 1) % sides.size()].reversed;
            EXPECT_EQ(sides[k].reversed ? arc.from : arc.to, next_reversed ? next.to : next.from);
            EXPECT_EQ(sides[k].reversed ? arc.right : arc.left, c);
            ++(sides[k].reversed ? right : left)[sides[k].arc];
        }
    }
    for (std::size_t a = 0; a < cells.arcs.size(); ++a) {
        EXPECT_EQ(left[a], 1);
        EXPECT_EQ(right[a], 1);
        EXPECT_NE(cells.arcs[a].left, cells.arcs[a].right);
    }
    for (std::int32_t c = 0; c < cells.cell_count(); ++c) {  // a cell of two sides has its width: a lune
        if (cells.cell(c).size() > 2) continue;
        const CellArc& arc = cells.arcs[cells.cell(c)[0].arc];
        EXPECT_LT(cells.vertices[arc.from].dot(cells.vertices[arc.to]), -0.8);
    }
    EXPECT_EQ(std::ssize(cells.vertices) - std::ssize(cells.arcs) + cells.cell_count(), 2);
    for (const int meet : cells_at_vertices(cells)) {
        EXPECT_GE(meet, 2);
        EXPECT_LE(meet, 6);  // so that no joint vertex has a valence above 12
    }
}

/// Area of a cell by the angles at its corners: each is seen from the middle of the cell, which is its site.
double area_of(const SphericalCells& cells, std::int32_t c) {
    double sum = 0;
    for (const CellSide& side : cells.cell(c)) {
        const CellArc& arc = cells.arcs[side.arc];
        const Vec3& a = cells.vertices[side.reversed ? arc.to : arc.from];
        const Vec3& b = cells.vertices[side.reversed ? arc.from : arc.to];
        const Vec3& s = cells.sites[c];  // area of a spherical triangle: van Oosterom and Strackee 1983
        sum += 2 * std::atan2(s.dot(a.cross(b)), 1 + s.dot(a) + a.dot(b) + b.dot(s));
    }
    return sum;
}

TEST(SphericalCells, TileTheSphereAreaAndAll) {
    property::Random random(3);
    SphericalCells cells;
    for (int n = 5; n <= 32; ++n) {
        find_spherical_cells(random_directions(random, n), cells);
        expect_tiling(cells);
        double area = 0;
        for (std::int32_t c = 0; c < cells.cell_count(); ++c) area += area_of(cells, c);
        EXPECT_NEAR(area, 4 * M_PI, 1e-9) << n;
    }
}

TEST(SphericalCells, OfFewDirectionsAreNeverWithoutWidth) {
    property::Random random(35);
    SphericalCells cells;
    for (int round = 0; round < 3000; ++round) {
        std::vector<Vec3> directions = random_directions(random, 4 + round % 3);
        if (round % 2 == 0)  // nearly in one plane
            for (Vec3& d : directions) d = Vec3(d.x(), d.y(), 0.2 * d.z()).normalized();
        find_spherical_cells(directions, cells);
        expect_tiling(cells);
    }
}

TEST(SphericalCells, MeetWhereTheirDirectionsAreEquallyNear) {
    const std::vector<Vec3> tetrahedron{Vec3(1, 1, 1).normalized(), Vec3(1, -1, -1).normalized(),
                                        Vec3(-1, 1, -1).normalized(), Vec3(-1, -1, 1).normalized()};
    SphericalCells cells;
    find_spherical_cells(tetrahedron, cells);
    expect_tiling(cells);
    EXPECT_EQ(cells.vertices.size(), 4u);
    for (const CellArc& arc : cells.arcs)
        for (const std::int32_t v : {arc.from, arc.to})
            EXPECT_NEAR(cells.vertices[v].dot(tetrahedron[arc.left]),
                        cells.vertices[v].dot(tetrahedron[arc.right]), 1e-5);
}

TEST(SphericalCells, OfThreeDirectionsAreLunes) {
    SphericalCells cells;
    for (const auto& directions : {fan(3), std::vector<Vec3>{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}}) {
        find_spherical_cells(directions, cells);
        expect_tiling(cells);
        EXPECT_EQ(cells.vertices.size(), 2u);
        EXPECT_TRUE(cells.vertices[0].isApprox(-cells.vertices[1], 1e-9));
    }
}

TEST(SphericalCells, OfACubesCornersMeetByFours) {
    const std::vector<Vec3> corners = cube_corners();
    SphericalCells cells;
    find_spherical_cells(corners, cells);
    expect_tiling(cells);
    EXPECT_EQ(cells_at_vertices(cells), std::vector<int>(6, 4));
}

TEST(SphericalCells, MoreThanSixRoundAVertexMakeRoomForOneOfItsOwn) {
    SphericalCells cells;
    for (int n = 3; n <= 40; ++n) {
        find_spherical_cells(fan(n), cells);
        expect_tiling(cells);
        EXPECT_EQ(cells.added, n <= 6 ? 0 : 2) << n;
        EXPECT_EQ(cells.cell_count(), n + cells.added);
    }
}

TEST(SphericalCells, OfEqualAndNearlyEqualDirectionsAreApart) {
    property::Random random(4);
    SphericalCells cells;
    for (const double spread : {0.0, 1e-9, 1e-3, 0.05})
        for (int n = 3; n <= 30; n += 3) {
            std::vector<Vec3> directions = random_directions(random, n);
            for (Vec3& d : directions) d = (spread * d + Vec3(2, -1, 1)).normalized();
            find_spherical_cells(directions, cells);
            expect_tiling(cells);
            for (std::int32_t i = 0; i < cells.cell_count(); ++i)
                for (std::int32_t k = 0; k < i; ++k)
                    EXPECT_GT((cells.sites[i] - cells.sites[k]).norm(), 0.01);
        }
}

TEST(SphericalCells, DoNotDependOnTheOrderOfTheDirections) {
    property::Random random(5);
    const std::vector<Vec3> directions = random_directions(random, 9);
    std::vector<Vec3> turned = directions;
    std::rotate(turned.begin(), turned.begin() + 4, turned.end());
    SphericalCells a, b;
    find_spherical_cells(directions, a);
    find_spherical_cells(turned, b);
    ASSERT_EQ(a.vertices.size(), b.vertices.size());
    for (const Vec3& v : a.vertices)
        EXPECT_TRUE(std::any_of(b.vertices.begin(), b.vertices.end(),
                                [&](const Vec3& w) { return (v - w).norm() < 1e-12; }));
}

}  // namespace
}  // namespace sinew::sqm
