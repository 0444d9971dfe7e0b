#include "sinew/mesh/measure.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "mesh/shapes.h"
#include "sinew/io/obj.h"

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

TEST(Measure, AgreesWithTheToolOfTheSharedFolder) {
    const char* shared = std::getenv("SINEW_SHARED");
    const std::filesystem::path tool =
        std::filesystem::path(shared ? shared : SINEW_SOURCE_FOLDER "/../shared") / "tools/meshstats.py";
    if (!std::filesystem::exists(tool)) GTEST_SKIP() << "there is no " << tool;
    const std::string path = testing::TempDir() + "sinew_measure";
    const QuadMesh cube = shapes::cube();
    QuadMesh touching = shapes::together(cube, shapes::moved(cube, {1, 1, 1}));
    for (std::uint32_t& v : touching.corners) v = v == 8 ? 7 : v;
    for (const QuadMesh& mesh : {shapes::tube(9, 5), shapes::torus(8, 7), shapes::octahedron(),
                                 shapes::without_faces(cube, {1, 2}), shapes::with_face_flipped(cube, 4),
                                 touching, shapes::together(shapes::sphere(4), shapes::tube(3, 11))}) {
        std::ofstream(path + ".obj") << obj_text(mesh);
        const std::string command =
            "/usr/bin/python3 " + tool.string() + " " + path + ".obj > " + path + ".json";
        if (std::system(command.c_str()) != 0) GTEST_SKIP() << "python3 with numpy is needed to run it";
        const auto told = nlohmann::json::parse(std::ifstream(path + ".json"));
        const Validation v = validate(mesh);
        const Measures m = measure(mesh);
        EXPECT_EQ(v.edges, told["E"]);
        EXPECT_EQ(v.boundary_edges.count, told["boundary_edges"]);
        EXPECT_EQ(v.nonmanifold_edges.count, told["nonmanifold_edges"]);
        EXPECT_EQ(v.nonmanifold_vertices.count, told["nonmanifold_verts"]);
        EXPECT_EQ(v.flipped_edges.count, told["flipped_edges"]);
        EXPECT_EQ(v.loose_vertices.count, told["loose_verts"]);
        EXPECT_EQ(v.components, told["components"]);
        EXPECT_EQ(v.euler, told["euler"]);
        EXPECT_EQ(v.closed() && v.manifold(), told["manifold"]);
        EXPECT_EQ(m.quads, told["quads"]);
        EXPECT_EQ(m.triangles, told["tris"]);
        EXPECT_EQ(m.irregular_vertices, told["extraordinary"]);
        EXPECT_EQ(std::max(m.max_valence, m.max_pole_valence), told["max_valence"]);
        EXPECT_NEAR(m.area, told["area"], 1e-5);
        if (v.closed() && v.oriented()) {
            EXPECT_NEAR(m.volume, told["volume"], 1e-5);
        }
    }
}

TEST(Measure, NothingAtAll) {
    const Measures m = measure(QuadMesh{});
    EXPECT_EQ(m.area, 0);
    EXPECT_EQ(m.edge_length.count, 0);
    EXPECT_EQ(m.high, Vec3(0, 0, 0));
}

}  // namespace
}  // namespace sinew
