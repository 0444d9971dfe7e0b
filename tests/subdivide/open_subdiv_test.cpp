/// Away from poles, circles and planes the result is OpenSubdiv's.
#include "subdivide/open_subdiv.h"

#include <gtest/gtest.h>

#include "sinew/subdivide/subdivide.h"
#include "subdivide/random_mesh.h"

namespace sinew {
namespace {

/// Levels 0 to 4 (fewer for large meshes) equal OpenSubdiv's to a millionth of the size.
void expect_equal(const QuadMesh& mesh, int levels = 4) {
    const auto theirs = open_subdiv::subdivide(mesh, levels);
    for (int level = 0; level <= levels; ++level) {
        const auto ours = subdivide(mesh, {.levels = level});
        ASSERT_TRUE(ours) << ours.error().text();
        SCOPED_TRACE(testing::Message() << "level " << level);
        open_subdiv::expect_same(mesh, *ours, theirs[std::size_t(level)]);
    }
}

QuadMesh sheet(int n) {
    QuadMesh mesh;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
            mesh.positions.emplace_back(float(i), float(j), std::sin(float(i + 2 * j)));
    const auto at = [&](int i, int j) { return std::uint32_t(j * (n + 1) + i); };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            mesh.add_face(std::array{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    return mesh;
}

TEST(OpenSubdiv, PlainShapes) {
    expect_equal(shapes::cube());
    expect_equal(shapes::octahedron());
    expect_equal(shapes::torus(5, 4), 3);
    expect_equal(sheet(3));
    QuadMesh tube = shapes::tube(3, 5);
    tube.features.poles.clear();
    expect_equal(tube, 3);
}

TEST(OpenSubdiv, RandomPolygonMeshes) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE(seed);
        shapes::RandomMesh random(seed);
        expect_equal(random.make(seed % 2 ? shapes::torus(8, 6) : shapes::sphere(3), {}), 3);
    }
}

TEST(OpenSubdiv, RandomCreasesAndCorners) {
    for (unsigned seed = 100; seed < 130; ++seed) {
        SCOPED_TRACE(seed);
        shapes::RandomMesh random(seed);
        const double crease = random.number() * 0.6;
        expect_equal(random.make(seed % 2 ? shapes::torus(6, 5) : shapes::sphere(2),
                                 {.crease = crease, .corner = 0.05}),
                     4);
    }
}

TEST(OpenSubdiv, OpenMeshes) {
    for (unsigned seed = 200; seed < 220; ++seed) {
        SCOPED_TRACE(seed);
        shapes::RandomMesh random(seed);
        expect_equal(random.make(seed % 2 ? sheet(6) : shapes::torus(7, 7),
                                 {.hole = 0.15, .crease = 0.2, .corner = 0.03}),
                     3);
    }
}

TEST(OpenSubdiv, CreaseCornerCases) {
    const MeshEdge edges[] = {{0, 1}, {1, 3}, {3, 2}, {2, 0}, {4, 5}, {5, 7},
                              {7, 6}, {6, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
    for (const float sharpness : {0.3f, 1.0f, 1.5f, 2.0f, 3.2f, 9.5f, 10.0f})
        for (std::size_t count = 1; count <= 12; ++count) {
            SCOPED_TRACE(testing::Message() << count << " edges of sharpness " << sharpness);
            QuadMesh mesh = shapes::cube();
            for (std::size_t e = 0; e < count; ++e) {
                const float own = e % 2 ? sharpness : std::min(10.0f, sharpness + 0.75f);
                mesh.features.creases.push_back({edges[e], own});
            }
            expect_equal(mesh);
        }
}

TEST(OpenSubdiv, NotManifold) {
    // Three quads at one edge; two cubes that touch at a vertex.
    QuadMesh fins;
    fins.positions = {{0, 0, 0},  {0, 0, 1},  {1, 0, 0},   {1, 0, 1},
                      {-1, 1, 0}, {-1, 1, 1}, {-1, -1, 0}, {-1, -1, 1}};
    for (const std::uint32_t a : {2u, 4u, 6u}) fins.add_face(std::array{0u, a, a + 1, 1u});
    expect_equal(fins);
    QuadMesh cubes = shapes::together(shapes::cube(), shapes::moved(shapes::cube(), {1, 1, 1}));
    for (std::uint32_t& v : cubes.corners) v = v == 8 ? 7 : v;
    expect_equal(cubes);
}

}  // namespace
}  // namespace sinew
