/// The tip at a pole is C2: the coefficients along successive rings are those of quadratics.
#include <gtest/gtest.h>

#include <complex>

#include "sinew/mesh/fans.h"
#include "sinew/subdivide/subdivide.h"
#include "subdivide/random_mesh.h"

namespace sinew {
namespace {

/// An open dome: a pole, which is vertex 0, and rings of n points with heights of their own.
QuadMesh random_dome(int n, int rings, unsigned seed) {
    shapes::RandomMesh random(seed);
    QuadMesh mesh;
    mesh.positions.emplace_back(0.0f, 0.0f, 0.2f);
    for (int k = 1; k <= rings; ++k)
        for (int j = 0; j < n; ++j) {
            const double a = 2 * std::numbers::pi * (j + 0.3 * random.number()) / n,
                         r = k * (1 + 0.2 * random.number());
            mesh.positions.emplace_back(float(r * std::cos(a)), float(r * std::sin(a)),
                                        float(-0.3 * k * k + random.number()));
        }
    const auto at = [&](int k, int j) { return std::uint32_t(1 + (k - 1) * n + j % n); };
    for (int j = 0; j < n; ++j) {
        mesh.add_face(std::array{0u, at(1, j), at(1, j + 1)});
        for (int k = 1; k < rings; ++k)
            mesh.add_face(std::array{at(k, j), at(k + 1, j), at(k + 1, j + 1), at(k, j + 1)});
    }
    mesh.features.poles = {0};
    return mesh;
}

/// Points of the first rings round a vertex: [k - 1][j] is the k-th on the straight way out along edge j.
std::vector<std::vector<Vec3>> rings_round(const QuadMesh& mesh, std::uint32_t vertex, std::size_t count) {
    const Topology topology = build_topology(mesh);
    std::vector<std::vector<Vec3>> rings(count);
    for (std::uint32_t h : topology.ring(vertex)) {
        for (std::size_t k = 0; k < count; ++k) {
            const std::uint32_t along = next_half_edge(mesh, topology, h);
            rings[k].push_back(mesh.positions[mesh.corners[along]].cast<double>());
            h = next_half_edge(mesh, topology, topology.twin[along]);
        }
    }
    return rings;
}

using Mode = Eigen::Vector3cd;
Mode mode_of(const std::vector<Vec3>& ring, int mode) {
    Mode sum = Mode::Zero();
    for (std::size_t j = 0; j < ring.size(); ++j)
        sum += std::polar(1.0, -2 * std::numbers::pi * mode * double(j) / double(ring.size())) *
               ring[j].cast<std::complex<double>>();
    return sum / double(ring.size());
}

/// The greatest distance of a ring from its modes -2 to 2.
double rest_of(const std::vector<Vec3>& ring) {
    if (ring.size() < 6) return 0;
    double rest = 0;
    for (std::size_t j = 0; j < ring.size(); ++j) {
        Mode sum = mode_of(ring, 0);
        for (int mode : {-2, -1, 1, 2})
            sum += std::polar(1.0, 2 * std::numbers::pi * mode * double(j) / double(ring.size())) *
                   mode_of(ring, mode);
        rest = std::max(rest, (sum.real() - ring[j]).norm());
    }
    return rest;
}

/// How far the coefficients of the first three rings are from those of a quadratic, over the quadratic part:
/// a cubic spline has k for x and k^2 - 1/3 for x^2, so mode 0 is c + a (k^2 - 1/3), mode 1 b k, mode 2 d
/// (k^2 - 1/3), no more.
double distance_from_quadratic(const QuadMesh& mesh, std::uint32_t pole) {
    const auto rings = rings_round(mesh, pole, 3);
    const bool has_mode_2 = rings[0].size() > 3;
    const Mode c0 = mesh.positions[pole].cast<double>().cast<std::complex<double>>();
    Mode mean[4] = {c0}, one[4], two[4];
    for (int k = 1; k <= 3; ++k) {
        mean[k] = mode_of(rings[std::size_t(k - 1)], 0);
        one[k] = mode_of(rings[std::size_t(k - 1)], 1);
        two[k] = has_mode_2 ? mode_of(rings[std::size_t(k - 1)], 2) : Mode::Zero();
    }
    const Mode a = mean[1] - mean[0], d = two[1] / (2.0 / 3);
    const double quadratic = a.norm() + d.norm();
    double off = 0;
    for (int k = 1; k <= 3; ++k) {
        off = std::max(off, (mean[k] - mean[0] - a * double(k * k)).norm());
        off = std::max(off, (one[k] - one[1] * double(k)).norm());
        off = std::max(off, (two[k] - d * (k * k - 1.0 / 3)).norm());
        off = std::max(off, rest_of(rings[std::size_t(k - 1)]));
    }
    return off / quadratic;
}

class Pole : public testing::TestWithParam<int> {};

TEST_P(Pole, IsC2WhereCatmullClarkIsNot) {
    const int n = GetParam();
    const QuadMesh dome = random_dome(n, 4, unsigned(n));
    QuadMesh plain = dome;
    plain.features.poles.clear();
    double off[2] = {}, plain_off[2] = {};
    for (int i = 0; i < 2; ++i) {
        const int levels = 4 + 2 * i;
        off[i] = distance_from_quadratic(*subdivide(dome, {.levels = levels}), 0);
        plain_off[i] = distance_from_quadratic(*subdivide(plain, {.levels = levels}), 0);
    }
    // What is left of ours is the cubic part, which halves a level and so tends to 0. What is off in the
    // other does not: at valence 4 its pole is regular, but of another shape than the net's (the triangles'
    // middles are what is rough).
    EXPECT_LT(off[1], 0.3 * off[0]);
    EXPECT_LT(off[1], 0.8);
    EXPECT_GT(plain_off[1], 0.8 * plain_off[0]);
    EXPECT_GT(plain_off[1], 2);
}

INSTANTIATE_TEST_SUITE_P(Valences, Pole, testing::Range(3, 17));

TEST(Poles, DoubleTheirValence) {
    const QuadMesh tube = shapes::tube(3, 5);
    for (int level = 0; level <= 3; ++level) {
        const QuadMesh mesh = *subdivide(tube, {.levels = level});
        const Topology topology = build_topology(mesh);
        EXPECT_EQ(mesh.features.poles, tube.features.poles);
        std::size_t triangles = 0;
        for (std::size_t f = 0; f < mesh.face_count(); ++f) triangles += mesh.face(f).size() == 3;
        const std::size_t valence = std::size_t(5) << level;
        EXPECT_EQ(triangles, 2 * valence);
        for (const std::uint32_t pole : tube.features.poles) EXPECT_EQ(topology.ring(pole).size(), valence);
        EXPECT_EQ(mesh.face_count(), tube.face_count() << 2 * level);
        EXPECT_EQ(detect_poles(mesh, topology), mesh.features.poles);
    }
}

TEST(Poles, AreSmoothOnBothSidesOfADoubleFan) {
    // Two fans that share their ring, and a mesh so round stays round.
    const int n = 8;
    QuadMesh mesh;
    for (int j = 0; j < n; ++j)
        mesh.positions.emplace_back(std::cos(2 * std::numbers::pi * j / n),
                                    std::sin(2 * std::numbers::pi * j / n), 0);
    mesh.positions.emplace_back(0.0f, 0.0f, 1.0f);
    mesh.positions.emplace_back(0.0f, 0.0f, -1.0f);
    for (std::uint32_t j = 0; j < n; ++j) {
        mesh.add_face(std::array{8u, j, (j + 1) % 8});
        mesh.add_face(std::array{9u, (j + 1) % 8, j});
    }
    mesh.features.poles = {8, 9};
    const double off = distance_from_quadratic(*subdivide(mesh, {.levels = 4}), 8);
    EXPECT_LT(distance_from_quadratic(*subdivide(mesh, {.levels = 6}), 8), 0.3 * off);
    EXPECT_TRUE(detect_poles(mesh, build_topology(mesh)).empty())
        << "nothing but triangles has no poles of its own";
}

TEST(Poles, ThatAreNoneAreOrdinaryVertices) {
    const auto same_as_plain = [](const QuadMesh& mesh) {
        QuadMesh plain = mesh;
        plain.features.poles.clear();
        const QuadMesh a = *subdivide(mesh, {.levels = 2}), b = *subdivide(plain, {.levels = 2});
        EXPECT_TRUE(a.features.poles.empty());
        return a.positions == b.positions && a.corners == b.corners;
    };
    QuadMesh neighbours = shapes::octahedron();
    neighbours.features.poles = {0, 2};
    EXPECT_TRUE(same_as_plain(neighbours));
    QuadMesh half = shapes::without_faces(shapes::octahedron(), {0});
    half.features.poles = {0};
    EXPECT_TRUE(same_as_plain(half)) << "on the boundary";
    QuadMesh quads = shapes::cube();
    quads.features.poles = {3};
    EXPECT_TRUE(same_as_plain(quads));
    QuadMesh ridge = shapes::tube(3, 6);
    ridge.features.poles = {19};
    ridge.features.creases = {{{19, 12}, 2}, {{19, 15}, 2}};
    EXPECT_TRUE(same_as_plain(ridge)) << "a crease runs over it";
}

TEST(Poles, AreFoundInMeshesWithoutAList) {
    QuadMesh tube = shapes::tube(3, 5);
    const std::vector<std::uint32_t> poles = tube.features.poles;
    const QuadMesh expected = *subdivide(tube, {.levels = 2});
    tube.features.poles.clear();
    EXPECT_EQ(subdivide(tube, {.levels = 2, .detect_poles = true})->positions, expected.positions);
    EXPECT_NE(subdivide(tube, {.levels = 2})->positions, expected.positions);
}

}  // namespace
}  // namespace sinew
