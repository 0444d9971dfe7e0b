/// What the features promise, after any number of levels.
#include <gtest/gtest.h>

#include "sinew/mesh/limit.h"
#include "sinew/mesh/validate.h"
#include "sinew/subdivide/subdivide.h"
#include "subdivide/feature_shapes.h"

namespace sinew {
namespace {

double distance_from_axis(const Vec3f& p) { return std::hypot(double{p.x()}, double{p.y()}); }

QuadMesh refined(const QuadMesh& mesh, int levels) {
    auto finer = subdivide(mesh, {.levels = levels});
    EXPECT_TRUE(finer) << finer.error().text();
    EXPECT_TRUE(validate(*finer).solid());
    return *finer;
}

class Levels : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(OneToFive, Levels, testing::Range(1, 6));

TEST_P(Levels, KeepFlatEndsFlatAndRound) {
    for (const std::size_t n : {4u, 5u, 6u, 9u}) {
        const double r = 0.7;
        const QuadMesh tube = shapes::flat_tube(3, n, r);
        const QuadMesh mesh = refined(tube, GetParam());
        for (std::size_t end = 0; end < 2; ++end) {
            const Plane& plane = mesh.features.planes[end];
            EXPECT_EQ(plane.faces.size(), n << 2 * GetParam());
            for (const std::uint32_t f : plane.faces)
                for (const std::uint32_t v : mesh.face(f))
                    EXPECT_NEAR(mesh.positions[v].z(), plane.point.z(), 1e-6 * r);
            const Circle& rim = mesh.features.circles[end];
            EXPECT_EQ(rim.edges.size(), n << GetParam());
            for (const MeshEdge& edge : rim.edges)
                for (const std::uint32_t v : edge)
                    EXPECT_NEAR(distance_from_axis(mesh.positions[v]), r, 1e-6 * r);
        }
        for (std::size_t v = 0; v < tube.vertex_count(); ++v)
            EXPECT_TRUE((v >= n && v < 2 * n) || mesh.positions[v] == tube.positions[v])
                << "vertex of a disc";
    }
}

TEST_P(Levels, SpreadDiscsEvenly) {
    // Rings inside the disc are circles of their own, evenly apart.
    const QuadMesh mesh = refined(shapes::flat_tube(2, 5), GetParam());
    const double rings = double(1 << GetParam());
    for (const std::uint32_t f : mesh.features.planes[1].faces)
        for (const std::uint32_t v : mesh.face(f)) {
            const double ring = distance_from_axis(mesh.positions[v]) * rings;
            EXPECT_NEAR(ring, std::round(ring), 1e-5);
        }
}

TEST_P(Levels, KeepConesStraightAndTheirTip) {
    for (const std::size_t n : {3u, 4u, 7u}) {
        const QuadMesh cone = shapes::cone(n, 2.5);
        const QuadMesh mesh = refined(cone, GetParam());
        EXPECT_EQ(mesh.positions[n + 1], cone.positions[n + 1]);
        for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
            const Vec3f& p = mesh.positions[v];
            EXPECT_TRUE(p.z() < 1e-6f || std::abs(distance_from_axis(p) - (1 - p.z() / 2.5)) < 1e-6) << p.z();
        }
    }
}

TEST_P(Levels, KeepConesWithoutACircleStraightToo) {
    // Only creased at the base: every generator is a straight line from the tip to the crease.
    QuadMesh cone = shapes::cone(6, 2.5);
    cone.features.circles.clear();
    for (std::size_t j = 0; j < 6; ++j) cone.positions[j].x() *= 1.6f;
    const QuadMesh mesh = refined(cone, GetParam());
    const Vec3f tip = cone.positions[7];
    EXPECT_EQ(mesh.positions[7], tip);
    const Topology topology = build_topology(mesh);
    for (std::uint32_t h : topology.ring(7)) {
        const Vec3f way = mesh.positions[mesh.corners[next_half_edge(mesh, topology, h)]] - tip;
        for (int k = 1; k <= 1 << GetParam(); ++k) {
            const std::uint32_t along = next_half_edge(mesh, topology, h);
            EXPECT_LT((mesh.positions[mesh.corners[along]] - tip - float(k) * way).norm(), 2e-6f);
            h = next_half_edge(mesh, topology, topology.twin[along]);
        }
    }
}

TEST_P(Levels, KeepBoxesPlanarStraightAndTheirCorners) {
    const QuadMesh box = shapes::box();
    const QuadMesh mesh = refined(box, GetParam());
    for (const Plane& plane : mesh.features.planes)
        for (const std::uint32_t f : plane.faces)
            for (const std::uint32_t v : mesh.face(f))
                EXPECT_NEAR((mesh.positions[v] - plane.point).dot(plane.normal), 0, 1e-6);
    for (const std::uint32_t v : box.features.corners) EXPECT_EQ(mesh.positions[v], box.positions[v]);
    for (const std::uint32_t v : box.features.poles) EXPECT_EQ(mesh.positions[v], box.positions[v]);
    // Every crease edge lies in two planes: the box's edges stay straight.
    for (const Crease& crease : mesh.features.creases)
        for (const std::uint32_t v : crease.edge) {
            int on = 0;
            for (int axis = 0; axis < 3; ++axis)
                on += std::abs(mesh.positions[v][axis]) < 1e-6f ||
                      mesh.positions[v][axis] == Vec3f(2, 3, 5)[axis];
            EXPECT_GE(on, 2);
        }
    EXPECT_EQ(mesh.features.creases.size(), box.features.creases.size() << GetParam());
}

TEST_P(Levels, KeepRimsOfPlanesThatAreNotCreasedInThem) {
    QuadMesh tube = shapes::tube(3, 8);
    tube.features.planes = {{{0, 0, 4}, Vec3f::UnitZ(), shapes::faces_at(tube, 25)}};
    const QuadMesh mesh = refined(tube, GetParam());
    for (const std::uint32_t f : mesh.features.planes[0].faces)
        for (const std::uint32_t v : mesh.face(f)) EXPECT_EQ(mesh.positions[v].z(), 4);
}

TEST(Fit, KeepsTheRadiusOfTubesRimToRim) {
    // A closed cubic B-spline of n points is out of round by 1.4 % at n = 4 and by 0.5 % at n = 5, and no
    // more comes to it, not even a waist beside the rims.
    for (int n = 4; n <= 16; ++n) {
        QuadMesh tube = shapes::flat_tube(5, std::size_t(n));
        shapes::fit(tube, [&](const Vec3f& p) {
            return Vec3(p.x() * ring_fit_radius(n), p.y() * ring_fit_radius(n), p.z());
        });
        const QuadMesh mesh = *subdivide(tube, {.levels = 3, .limit = true});
        for (const Vec3f& p : mesh.positions)
            if (p.z() > 1e-5f && p.z() < 4 - 1e-5f) {
                ASSERT_NEAR(distance_from_axis(p), 1, n == 4 ? 0.015 : 0.005) << n << " at " << p.z();
            }
    }
}

TEST(Fit, KeepsTheRadiusOfRoundEndedTubesAndSpheres) {
    for (int n = 4; n <= 16; ++n)
        for (const int straight : {0, 4}) {
            QuadMesh mesh = shapes::capsule(n, straight);
            shapes::fit(mesh, [&](const Vec3f& p) { return p.cast<double>(); });
            const QuadMesh finer = *subdivide(mesh, {.levels = 3, .limit = true});
            double least = 2, most = 0;
            for (const Vec3f& p : finer.positions) {
                const Vec3f on_axis(0, 0, std::clamp(p.z(), 0.0f, float(straight)));
                least = std::min(least, double{(p - on_axis).norm()});
                most = std::max(most, double{(p - on_axis).norm()});
            }
            // Half way between its rings a tube of few rings feels its ends.
            const double allowed = n < 6 ? 0.04 : straight > 0 ? 0.016 : 0.01;
            EXPECT_GT(least, 1 - allowed) << n << " " << straight;
            EXPECT_LT(most, 1 + allowed) << n << " " << straight;
        }
}

TEST(Subdivide, LosesOneOfItsSharpnessALevel) {
    QuadMesh mesh = shapes::cube();
    mesh.features.creases = {{{0, 1}, 2.5f}, {{0, 2}, 10}, {{1, 3}, 1}, {{2, 3}, 30}};
    for (const auto& [levels, expected] :
         {std::pair<int, std::vector<float>>{1, {1.5f, 1.5f, 10, 10, 30, 30}},
          std::pair<int, std::vector<float>>{3, std::vector<float>(16, 10)}}) {
        std::vector<float> sharpness;
        for (const Crease& crease : refined(mesh, levels).features.creases)
            sharpness.push_back(crease.sharpness);
        std::ranges::sort(sharpness);
        if (levels == 1)
            EXPECT_EQ(sharpness, expected);
        else
            EXPECT_EQ(sharpness.size(), 16u) << "the infinite ones, each in eight";
    }
}

TEST(Subdivide, CarriesWhereVerticesCameFrom) {
    // Along a bone the parameter of a new vertex is the mean of those it lies between.
    const std::size_t m = 4, n = 6;
    QuadMesh tube = shapes::tube(m, n);
    for (std::size_t v = 0; v < tube.vertex_count(); ++v) {
        const std::size_t ring = std::min(v / n, m - 1);
        const bool cap = v >= m * n;
        tube.vertex_node.push_back(cap ? 9 : int(ring));
        tube.vertex_bone.push_back(cap ? -1 : 5);
        tube.vertex_along.push_back(cap ? 0 : float(ring) / float(m - 1));
    }
    const QuadMesh mesh = refined(tube, 2);
    ASSERT_EQ(mesh.vertex_node.size(), mesh.vertex_count());
    for (std::size_t v = 0; v < tube.vertex_count(); ++v) {
        EXPECT_EQ(mesh.vertex_node[v], tube.vertex_node[v]);
        EXPECT_EQ(mesh.vertex_along[v], tube.vertex_along[v]);
    }
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        const Vec3f& p = mesh.positions[v];
        if (p.z() < 0.9f || p.z() > 3.1f) continue;
        EXPECT_EQ(mesh.vertex_bone[v], 5);
        EXPECT_NEAR(mesh.vertex_along[v], p.z() / 4, 0.02);
        EXPECT_LE(std::abs(mesh.vertex_node[v] - p.z() * 0.75f), 1.01f);
    }
    EXPECT_TRUE(refined(shapes::tube(m, n), 1).vertex_node.empty());
}

TEST(Subdivide, MixesNoParametersOfDifferentBones) {
    // Rings 0 and 1 lie on bone 5, at its beginning and end, rings 2 and 3 on bone 6, which goes on from
    // there.
    const std::size_t m = 4, n = 6;
    QuadMesh tube = shapes::tube(m, n);
    for (std::size_t v = 0; v < tube.vertex_count(); ++v) {
        const std::size_t ring = v < m * n ? v / n : v == m * n ? 0 : m - 1;
        tube.vertex_bone.push_back(ring < 2 ? 5 : 6);
        tube.vertex_along.push_back(ring % 2 == 0 ? 0 : 1);
    }
    const QuadMesh mesh = refined(tube, 1);
    int between = 0;
    for (std::size_t v = tube.vertex_count(); v < mesh.vertex_count(); ++v) {
        const float z = mesh.positions[v].z();
        if (std::abs(z - 2) > 0.3f) continue;  // half way from ring 1 to ring 2
        EXPECT_EQ(mesh.vertex_along[v], mesh.vertex_bone[v] == 5 ? 1 : 0)
            << "the end of 5 or the beginning of 6";
        ++between;
    }
    EXPECT_EQ(between, 2 * n) << "a point for each edge and each face";
}

}  // namespace
}  // namespace sinew
