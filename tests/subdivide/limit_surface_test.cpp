/// Limit positions and normals of finer levels.
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "sinew/mesh/limit.h"
#include "sinew/subdivide/subdivide.h"
#include "subdivide/feature_shapes.h"
#include "subdivide/open_subdiv.h"
#include "subdivide/random_mesh.h"

namespace sinew {
namespace {

std::vector<Vec3f> limit_at(const QuadMesh& mesh, int levels) {
    auto finer = subdivide(mesh, {.levels = levels, .limit = true});
    EXPECT_TRUE(finer) << finer.error().text();
    return finer->positions;
}

/// The limit of a vertex is one and the same from whichever level it is found.
void expect_one_limit(const QuadMesh& mesh) {
    const std::vector<Vec3f> from_control = *limit_positions(mesh);
    for (int levels = 0; levels <= 4; ++levels) {
        const std::vector<Vec3f> limit = limit_at(mesh, levels);
        for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
            ASSERT_LT((limit[v] - from_control[v]).norm(), 4e-6f) << "level " << levels << " vertex " << v;
    }
}

TEST(LimitSurface, IsTheSameFromEveryLevel) {
    expect_one_limit(shapes::tube(3, 5));
    QuadMesh four = shapes::tube(2, 4);
    four.features.creases.push_back({{4, 5}, 1.5f});
    four.features.creases.push_back({{5, 6}, 2.25f});
    expect_one_limit(four);
    for (unsigned seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE(seed);
        shapes::RandomMesh random(seed);
        expect_one_limit(random.make(seed % 2 ? shapes::torus(6, 5) : shapes::sphere(2),
                                     {.hole = seed % 3 ? 0.0 : 0.1, .crease = 0.3, .corner = 0.05}));
    }
}

TEST(LimitSurface, RoundUnevenPolesIsTheSameFromEveryLevel) {
    for (const std::size_t valence : {3u, 5u, 8u}) {
        QuadMesh mesh = shapes::tube(3, valence);
        for (std::size_t v = 0; v < mesh.vertex_count(); ++v)  // no two spokes alike
            mesh.positions[v] +=
                0.2f * Vec3f(std::sin(2.0f * float(v)), std::cos(3.0f * float(v)), std::sin(5.0f * float(v)));
        expect_one_limit(mesh);
    }
}

TEST(LimitSurface, OfCirclesDiscsConesAndBoxesIsWhereTheyAre) {
    // Finer vertices beside a circle see it better, so only what has no circle beside it has one limit.
    for (const QuadMesh& mesh : {shapes::flat_tube(4, 6), shapes::cone(7, 2), shapes::box()}) {
        const QuadMesh finer = *subdivide(mesh, {.levels = 2});
        const std::vector<Vec3f> limit = limit_at(mesh, 2);
        for (const Circle& circle : finer.features.circles)
            for (const MeshEdge& edge : circle.edges) EXPECT_EQ(limit[edge[0]], finer.positions[edge[0]]);
        for (const std::uint32_t corner : finer.features.corners)
            EXPECT_EQ(limit[corner], finer.positions[corner]);
        for (const Plane& plane : finer.features.planes)
            for (const std::uint32_t f : plane.faces)
                for (const std::uint32_t v : finer.face(f))
                    EXPECT_NEAR((limit[v] - plane.point).dot(plane.normal), 0, 1e-6);
    }
    expect_one_limit(shapes::box());
}

TEST(LimitSurface, IsOpenSubdivs) {
    // Smooth, infinitely sharp and open vertices are compared: its limits ignore fractions and darts, and at
    // a vertex of two edges are not where its own subdivision goes.
    for (unsigned seed = 0; seed < 8; ++seed) {
        shapes::RandomMesh random(seed);
        QuadMesh mesh =
            random.make(seed % 2 ? shapes::torus(6, 5) : shapes::sphere(2), {.hole = seed % 3 ? 0.0 : 0.1});
        for (const MeshEdge& edge : build_topology(mesh).edges)
            if (edge[0] % 3 == 0 && edge[1] % 3 == 0) mesh.features.creases.push_back({edge, 10});
        const auto theirs = open_subdiv::subdivide(mesh, 2, true).back();
        const std::vector<Vec3f> ours = limit_at(mesh, 2);
        const Topology topology = build_topology(mesh);
        const auto sharpness = *resolve_sharpness(mesh, topology);
        for (std::uint32_t v = 0; v < ours.size(); ++v) {
            const std::uint32_t sharp = find_sharp_vertex(sharpness, v);
            if (sharp != no_index && sharpness.spokes_of(sharp).size() == 1) continue;
            if (sharp == no_index && v < mesh.vertex_count() && topology.ring(v).size() == 2) continue;
            EXPECT_LT((ours[v].cast<double>() - theirs[v]).norm(), 1e-6 * 8) << seed << " " << v;
        }
    }
}

/// Normals of a fine level, by the geometry of the limit surface there: what they must be near to.
void expect_normals(const QuadMesh& mesh, int levels, double allowed) {
    auto subdivider = Subdivider::build(mesh, {.levels = levels, .limit = true});
    ASSERT_TRUE(subdivider);
    const QuadMesh& finer = subdivider->mesh();
    const std::vector<Vec3f> normals = subdivider->limit_normals();
    ASSERT_EQ(normals.size(), finer.corners.size());
    for (std::size_t f = 0; f < finer.face_count(); ++f) {
        const auto face = finer.face(f);
        for (std::size_t i = 0; i < face.size(); ++i) {
            const Vec3f& p = finer.positions[face[i]];
            const Vec3f& next = finer.positions[face[(i + 1) % face.size()]];
            const Vec3f& before = finer.positions[face[(i + face.size() - 1) % face.size()]];
            const Vec3f flat = (next - p).cross(before - p).normalized();
            const Vec3f& normal = normals[finer.face_offsets[f] + i];
            EXPECT_NEAR(normal.norm(), 1, 1e-5);
            EXPECT_GT(normal.dot(flat), 1 - allowed)
                << "face " << f << " corner " << i << " at " << p.transpose();
        }
    }
}

TEST(LimitNormals, AreThoseOfTheSurface) {
    expect_normals(shapes::tube(4, 6), 5, 0.01);
    expect_normals(shapes::tube(3, 4), 5, 0.01);
    expect_normals(shapes::flat_tube(4, 6), 5, 0.01);
    expect_normals(shapes::cone(5, 2), 5, 0.01);
    expect_normals(shapes::box(), 5, 0.01);
    QuadMesh cube = shapes::cube();
    cube.features.creases = {{{0, 1}, 10}, {{1, 3}, 10}, {{2, 3}, 10}, {{0, 2}, 10}, {{4, 5}, 1.5f}};
    expect_normals(cube, 6, 0.02);
    QuadMesh dart = shapes::grid_cube(2);
    dart.features.creases = {{build_topology(dart).edges[3], 10}};
    expect_normals(dart, 6, 0.03);
}

TEST(LimitNormals, AreExactOnACone) {
    const auto cone = Subdivider::build(shapes::cone(6, 2), {.levels = 2, .limit = true});
    const std::vector<Vec3f> normals = cone->limit_normals();
    const QuadMesh& mesh = cone->mesh();
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::size_t c = mesh.face_offsets[f]; c < mesh.face_offsets[f + 1]; ++c) {
            const Vec3f& p = mesh.positions[mesh.corners[c]];
            if (p.z() < 1e-6f || p.z() > 2 - 1e-6f) continue;
            const Vec3f outward = Vec3f(p.x() / (1 - p.z() / 2), p.y() / (1 - p.z() / 2), 0.5f).normalized();
            EXPECT_GT(normals[c].dot(outward), 1 - 1e-6f);
        }
}

TEST(LimitNormals, AreNearlyRadialOnASphereFittedToItsLimit) {
    QuadMesh sphere = shapes::capsule(16, 0);
    shapes::fit(sphere, [](const Vec3f& p) { return p.cast<double>(); });
    const auto subdivider = Subdivider::build(sphere, {.levels = 3, .limit = true});
    const std::vector<Vec3f> normals = subdivider->limit_normals();
    const QuadMesh& mesh = subdivider->mesh();
    for (std::size_t c = 0; c < mesh.corners.size(); ++c) {
        const Vec3f outward = mesh.positions[mesh.corners[c]].normalized();
        EXPECT_GT(normals[c].dot(outward), std::cos(0.02f)) << outward.transpose();
    }
}

TEST(LimitNormals, AgreeBetweenLevels) {
    // Corner i of a face is corner 0 of its part i, at the same vertex and on the same side of all creases.
    for (unsigned seed = 0; seed < 6; ++seed) {
        shapes::RandomMesh random(seed);
        QuadMesh mesh =
            random.make(seed % 2 ? shapes::torus(6, 5) : shapes::sphere(2), {.hole = seed % 3 ? 0.0 : 0.1});
        for (const MeshEdge& edge : build_topology(mesh).edges)
            if (edge[0] % 3 == 0 && edge[1] % 2 == 0)
                mesh.features.creases.push_back({edge, edge[0] % 2 ? 1.5f : 10.0f});
        const auto sharpness = *resolve_sharpness(mesh, build_topology(mesh));
        const auto coarse = Subdivider::build(mesh, {.levels = 1}),
                   fine = Subdivider::build(mesh, {.levels = 3});
        const std::vector<Vec3f> one = coarse->limit_normals(), three = fine->limit_normals();
        for (std::size_t f = 0; f < coarse->mesh().face_count(); ++f) {
            const std::uint32_t v = coarse->mesh().face(f)[0];
            const std::uint32_t sharp = find_sharp_vertex(sharpness, v);
            if (sharp != no_index && (sharpness.spokes_of(sharp).size() != 2 || sharpness.corner[sharp]))
                continue;
            EXPECT_GT(one[4 * f].dot(three[4 * (16 * f)]), 1 - 1e-5f) << seed << " vertex " << v;
        }
    }
}

TEST(LimitNormals, SeveralThreadsMayAskForAtOnce) {
    // Circles are what positions would have to move for.
    for (const bool limit : {false, true})
        for (const int levels : {0, 3}) {
            const auto made =
                Subdivider::build(shapes::flat_tube(12, 16), {.levels = levels, .limit = limit});
            ASSERT_TRUE(made);
            const Subdivider& tube = *made;
            const std::vector<Vec3f> normals = tube.limit_normals(), positions = tube.mesh().positions;
            std::atomic<int> wrong = 0;
            std::vector<std::thread> threads;
            for (int i = 0; i < 4; ++i)
                threads.emplace_back([&] {
                    for (int k = 0; k < 20; ++k)
                        wrong += tube.limit_normals() != normals || tube.mesh().positions != positions;
                });
            for (std::thread& thread : threads) thread.join();
            EXPECT_EQ(wrong, 0) << levels << " " << limit;
        }
}

}  // namespace
}  // namespace sinew
