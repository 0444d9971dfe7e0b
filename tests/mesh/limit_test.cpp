#include "sinew/mesh/limit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/shapes.h"

namespace sinew {
namespace {

std::vector<Vec3> doubles(const QuadMesh& mesh) {
    std::vector<Vec3> points;
    for (const Vec3f& p : mesh.positions) points.push_back(p.cast<double>());
    return points;
}

std::vector<Vec3f> limit_of(const QuadMesh& mesh) {
    auto limit = limit_positions(mesh);
    EXPECT_TRUE(limit) << limit.error().text();
    return limit.value_or(mesh.positions);
}

double distance_from_axis(const Vec3f& p) { return std::hypot(p.x(), p.y()); }

TEST(Limit, OfATorusIsTheTensorProductOfItsRings) {
    const std::size_t m = 7, n = 5;
    const std::vector<Vec3f> limit = limit_of(shapes::torus(m, n));
    const double round = ring_limit_radius(m), across = ring_limit_radius(n);
    for (std::size_t j = 0; j < n; ++j) {
        const double b = 2 * std::numbers::pi * double(j) / double(n);
        EXPECT_NEAR(limit[j].x(), round * (3 + across * std::cos(b)), 1e-6);
        EXPECT_NEAR(limit[j].z(), across * std::sin(b), 1e-6);
    }
}

TEST(Limit, OfACubeIsKnown) {
    // Valence 3 after one step: (9 v' + 4 sum e' + sum f') / 24 = (4 v + ... ) along the diagonal.
    for (const Vec3f& p : limit_of(shapes::cube()))
        for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(std::abs(p[axis] - 0.5f), 0.25, 1e-6);
}

TEST(Limit, OfAPoleLiesAThirdOfTheWayToItsRing) {
    QuadMesh mesh = shapes::tube(4, 8);
    const std::uint32_t top = mesh.features.poles[1];
    mesh.positions[top].z() += 1;
    const std::vector<Vec3f> limit = limit_of(mesh);
    EXPECT_LT((limit[top] - Vec3f(0, 0, 4 + 2.0f / 3)).norm(), 1e-6f);
}

TEST(Limit, BesideAPoleIsTheRegularOneOfAQuadratic) {
    // Rings k = 0, 1, 2 .. of radius k and height k^2 - 1/3 are the spline x = k, z = k^2, but for the
    // roundness.
    const int n = 64;
    QuadMesh mesh = shapes::tube(5, n);
    for (int k = 1; k <= 5; ++k)
        for (int j = 0; j < n; ++j) {
            Vec3f& p = mesh.positions[std::size_t(n * (5 - k) + j)];
            p = Vec3f(p.x() * float(k), p.y() * float(k), float(k * k) - 1.0f / 3);
            if (k == 5) p.z() = -10;
        }
    mesh.positions[mesh.features.poles[1]] = Vec3f(0, 0, -1.0f / 3);
    for (Vec3f& p : mesh.positions) p.z() = -p.z();
    std::vector<Vec3f> limit = limit_of(mesh);
    EXPECT_NEAR(limit[mesh.features.poles[1]].z(), 0, 1e-6);
    for (int k = 1; k <= 3; ++k) {
        const Vec3f& p = limit[std::size_t(n * (5 - k))];
        EXPECT_NEAR(p.z(), -k * k, 1e-5);
        EXPECT_NEAR(distance_from_axis(p), k * ring_limit_radius(n), 1e-5);
    }
}

TEST(Limit, OfCreasesBoundariesAndCorners) {
    // An open sheet of 3 x 3 quads, with a crease along one inner line.
    QuadMesh sheet;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
            sheet.positions.emplace_back(float(i), float(j), float((i * i * 7 + j * 5) % 4));
    for (std::uint32_t j = 0; j < 3; ++j)
        for (std::uint32_t i = 0; i < 3; ++i) {
            const std::uint32_t a = 4 * j + i;
            sheet.add_face(std::array{a, a + 1, a + 5, a + 4});
        }
    for (std::uint32_t j = 0; j < 3; ++j) sheet.features.creases.push_back({{4 * j + 1, 4 * j + 5}, 10});
    const std::vector<Vec3f> limit = limit_of(sheet);
    const auto& p = sheet.positions;
    EXPECT_EQ(limit[0], p[0]) << "a boundary corner stays";
    EXPECT_EQ(limit[1], p[1]) << "where a crease ends on the boundary is a corner";
    EXPECT_LT((limit[2] - (4 * p[2] + p[1] + p[3]) / 6).norm(), 1e-6f);
    EXPECT_LT((limit[5] - (4 * p[5] + p[1] + p[9]) / 6).norm(), 1e-6f);
}

TEST(Limit, OfFadingCreasesLiesBetweenSmoothAndSharp) {
    double previous = -1;
    for (const float sharpness : {0.0f, 0.5f, 1.0f, 1.7f, 2.0f, 4.0f, 9.0f, 10.0f}) {
        QuadMesh mesh = shapes::cube();
        for (const MeshEdge& edge : build_topology(mesh).edges)
            mesh.features.creases.push_back({edge, sharpness});
        const double out = limit_of(mesh)[7].x();
        EXPECT_GT(out, previous);
        previous = out;
    }
    EXPECT_EQ(previous, 1) << "infinitely sharp edges make corners";
}

TEST(Limit, KeepsCirclesDiscsAndTips) {
    QuadMesh mesh = shapes::tube(3, 6);
    const auto [bottom, top] = std::array{mesh.features.poles[0], mesh.features.poles[1]};
    Circle rim{.centre = {0, 0, 4}};
    for (std::uint32_t j = 0; j < 6; ++j) rim.edges.push_back({12 + j, 12 + (j + 1) % 6});
    mesh.features.circles = {rim};
    mesh.positions[bottom].z() -= 3;
    mesh.features.corners = {bottom, top};
    const std::vector<Vec3f> limit = limit_of(mesh);
    EXPECT_EQ(limit[bottom], mesh.positions[bottom]);
    EXPECT_EQ(limit[top], mesh.positions[top]);
    for (std::size_t j = 12; j < 18; ++j) EXPECT_EQ(limit[j], mesh.positions[j]);
    // The ring below sees the control points of a spline along the rim.
    const double seen = ring_fit_radius(6) / ring_limit_radius(6);
    EXPECT_NEAR(distance_from_axis(limit[6]), ring_limit_radius(6) * (1 + 4 + seen) / 6, 1e-6);
}

TEST(Limit, OfThoseAskedForIsTheSameAsOfAll) {
    QuadMesh mesh = shapes::tube(6, 8);
    const std::vector<Vec3> points = doubles(mesh);
    mesh.features.creases = {{{0, 1}, 1.5f}, {{1, 2}, 20}};
    std::vector<Vec3> all(points.size()), some(points.size());
    limit_positions(build_limit_stencils(mesh).value(), points, all);
    for (const std::size_t third : {0u, 1u, 2u}) {
        std::vector<char> wanted(points.size(), 0);
        for (std::size_t v = third; v < wanted.size(); v += 3) wanted[v] = 1;
        limit_positions(build_limit_stencils(mesh, wanted).value(), points, some);
        for (std::size_t v = 0; v < points.size(); ++v)
            EXPECT_EQ(some[v], wanted[v] ? all[v] : points[v]) << v;
    }
    EXPECT_NE(all, points);
}

TEST(Limit, FittingFindsTheControlPoints) {
    for (const std::size_t n : {4u, 5u, 8u, 16u}) {
        const QuadMesh mesh = shapes::tube(9, n);
        const auto stencils = build_limit_stencils(mesh);
        ASSERT_TRUE(stencils);
        const std::vector<Vec3> target = doubles(mesh);
        std::vector<Vec3> control = target, limit = target;
        fit_to_limit(*stencils, target, control);
        limit_positions(*stencils, std::span<const Vec3>(control), limit);
        for (std::size_t v = 0; v < target.size(); ++v)
            EXPECT_LT((limit[v] - target[v]).norm(), 1e-3) << n << " " << v;
    }
}

TEST(Limit, NamesWhatItRefuses) {
    QuadMesh mesh = shapes::cube();
    mesh.features.creases = {{{0, 7}, 1}};
    EXPECT_THAT(build_limit_stencils(mesh).error().message, testing::HasSubstr("vertices 0 and 7"));
    mesh = shapes::cube();
    mesh.corners[1] = mesh.corners[0];
    EXPECT_THAT(build_limit_stencils(mesh).error().message, testing::HasSubstr("face 0"));
}

}  // namespace
}  // namespace sinew
