#include "sinew/mesh/measure.h"

#include <gtest/gtest.h>

#include <numbers>

#include "mesh/shapes.h"

namespace sinew {
namespace {

TEST(Measure, Cube) {
    const Measures m = measure(shapes::cube());
    EXPECT_EQ(m.quads, 6);
    EXPECT_EQ(m.triangles + m.ngons, 0);
    EXPECT_EQ(m.irregular_vertices, 8);
    EXPECT_EQ(m.max_valence, 3);
    EXPECT_EQ(m.poles, 0);
    EXPECT_EQ(m.low, Vec3(0, 0, 0));
    EXPECT_EQ(m.high, Vec3(1, 1, 1));
    EXPECT_DOUBLE_EQ(m.area, 6);
    EXPECT_DOUBLE_EQ(m.volume, 1);
    EXPECT_DOUBLE_EQ(m.edge_length.min, 1);
    EXPECT_DOUBLE_EQ(m.edge_length.max, 1);
    EXPECT_EQ(m.edge_length.count, 12);
    EXPECT_DOUBLE_EQ(m.quad_quality.min, 1);
    EXPECT_DOUBLE_EQ(m.quad_aspect.max, 1);
    EXPECT_FALSE(m.zero_area);
    EXPECT_FALSE(m.folded_quads);
}

TEST(Measure, OctahedronAndGridCube) {
    const Measures octahedron = measure(shapes::octahedron());
    EXPECT_EQ(octahedron.triangles, 8);
    EXPECT_EQ(octahedron.stray_triangles, 8) << "where all are triangles none is a pole's";
    EXPECT_EQ(octahedron.irregular_vertices, 0);
    EXPECT_DOUBLE_EQ(octahedron.area, 4 * std::numbers::sqrt3);
    EXPECT_DOUBLE_EQ(octahedron.volume, 4.0 / 3);

    const Measures grid = measure(shapes::grid_cube(64));
    EXPECT_EQ(grid.quads, 6 * 64 * 64);
    EXPECT_EQ(grid.irregular_vertices, 8);
    EXPECT_NEAR(grid.area, 24, 1e-6);
    EXPECT_NEAR(grid.volume, 8, 1e-6);
}

TEST(Measure, TorusNearsPappus) {
    const Measures m = measure(shapes::torus(400, 200));
    const double pi = std::numbers::pi;
    EXPECT_NEAR(m.volume, 2 * pi * 3 * pi, 0.001 * m.volume);
    EXPECT_NEAR(m.area, 2 * pi * 3 * 2 * pi, 0.001 * m.area);
    EXPECT_EQ(m.irregular_vertices, 0);
}

TEST(Measure, TubeWithPoles) {
    const int n = 16;
    const Measures m = measure(shapes::tube(5, n, 2, 12));
    const double section = n * 0.5 * 4 * std::sin(2 * std::numbers::pi / n);
    EXPECT_NEAR(m.volume, 12 * section, 1e-4);
    EXPECT_EQ(m.triangles, 2 * n);
    EXPECT_EQ(m.stray_triangles, 0);
    EXPECT_EQ(m.poles, 2);
    EXPECT_EQ(m.irregular_vertices, 2);
    EXPECT_EQ(m.max_valence, 4);
    EXPECT_EQ(m.max_pole_valence, n);
}

TEST(Measure, ReflectionFlipsTheVolumeAndNothingElse) {
    const QuadMesh mesh = shapes::moved(shapes::tube(7, 9, 1, 5), {3, -2, 8});
    QuadMesh mirrored = mesh;
    for (Vec3f& p : mirrored.positions) p.x() = -p.x();
    const Measures a = measure(mesh), b = measure(mirrored);
    EXPECT_NEAR(a.volume, -b.volume, 1e-12 * a.volume);
    EXPECT_NEAR(a.area, b.area, 1e-12 * a.area);
    EXPECT_EQ(a.quad_quality.min, b.quad_quality.min);
}

TEST(Measure, VolumeFarFromTheOrigin) {
    const float far = 1 << 20;
    EXPECT_NEAR(measure(shapes::moved(shapes::cube(), {far, -far, far})).volume, 1, 1e-9);
}

TEST(Measure, ScaleChangesSizesOnly) {
    const QuadMesh mesh = shapes::torus(9, 7);
    QuadMesh large = mesh;
    for (Vec3f& p : large.positions) p *= 1 << 20;
    const Measures a = measure(mesh), b = measure(large);
    EXPECT_DOUBLE_EQ(b.area, a.area * std::pow(2.0, 40));
    EXPECT_DOUBLE_EQ(b.volume, a.volume * std::pow(2.0, 60));
    EXPECT_DOUBLE_EQ(b.quad_quality.mean, a.quad_quality.mean);
    EXPECT_EQ(a.zero_area.count, b.zero_area.count);
}

TEST(Measure, FlatAndFoldedFaces) {
    QuadMesh mesh = shapes::from_faces({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0.25f, 0}},
                                       {{0, 1, 2}, {0, 2, 3, 4}, {0, 4, 2, 3}, {0, 1, 3}, {0, 0, 1}});
    const Measures m = measure(mesh);
    EXPECT_EQ(m.zero_area.examples, (std::vector<std::uint32_t>{0, 4}));
    EXPECT_EQ(m.folded_quads.examples, (std::vector<std::uint32_t>{1, 2}))
        << "both are bent inwards at vertex 4";
    const Measures square =
        measure(shapes::from_faces({{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}));
    EXPECT_DOUBLE_EQ(square.quad_aspect.mean, 3);
    EXPECT_DOUBLE_EQ(square.quad_quality.mean, 1);
}

TEST(Measure, NothingAtAll) {
    const Measures m = measure(QuadMesh{});
    EXPECT_EQ(m.area, 0);
    EXPECT_EQ(m.edge_length.count, 0);
    EXPECT_EQ(m.high, Vec3(0, 0, 0));
}

}  // namespace
}  // namespace sinew
