#include "sinew/io/mesh_formats.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <limits>

#include "io/mesh_testing.h"
#include "io/temporary_folder.h"
#include "sinew/io/files.h"
#include "sinew/mesh/measure.h"

namespace sinew {
namespace {

using testing::HasSubstr;

TEST(MeshFormats, EveryFormatThatIsReadGivesBackWhatWasWritten) {
    const TemporaryFolder folder;
    const QuadMesh mesh = shapes::tube(6, 8);
    int both = 0;
    for (const Format& format : formats()) {
        if (!format.writes_mesh) continue;
        const std::string path = folder / ("mesh" + std::string(format.extension));
        ASSERT_TRUE(write_mesh(mesh, path)) << format.name;
        if (!format.reads_mesh) continue;
        const Result<QuadMesh> read = read_mesh(path);
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_EQ(read->positions, mesh.positions) << format.name;
        EXPECT_EQ(measure(*read).quads, format.carries.quads ? 40 : 0) << format.name;
        EXPECT_TRUE(validate(*read).solid()) << format.name;
        ++both;
    }
    EXPECT_EQ(both, 5) << "obj, ply, gltf, glb and usda";
}

TEST(MeshFormats, TheTableSaysWhichHoldCreases) {
    QuadMesh mesh = shapes::cube();
    mesh.features.creases = {{{0, 1}, 3.0f}};
    for (const Format& format : formats()) {
        if (!format.writes_mesh || !format.reads_mesh) continue;
        const QuadMesh read = *parse_mesh(*mesh_bytes(mesh, format.id), format.id, "m");
        EXPECT_EQ(!read.features.creases.empty(), format.carries.creases) << format.name;
    }
}

TEST(MeshFormats, TheSameMeshGivesTheSameBytes) {
    const QuadMesh mesh = shapes::grid_cube(60);  // large enough for several blocks
    for (const Format& format : formats()) {
        if (!format.writes_mesh) continue;
        EXPECT_EQ(*mesh_bytes(mesh, format.id), *mesh_bytes(mesh, format.id)) << format.name;
    }
}

TEST(MeshFormats, ANameGoesBeforeTheExtension) {
    const TemporaryFolder folder;
    const std::string path = folder / "mesh.dat";
    ASSERT_TRUE(write_mesh(shapes::cube(), path, {.format = "ply", .ascii = true}));
    EXPECT_THAT(*read_file(path), testing::StartsWith("ply\nformat ascii 1.0\n"));
    EXPECT_TRUE(read_mesh(path, "ply"));
    EXPECT_EQ(read_mesh(path).error().kind, ErrorKind::call);
    EXPECT_EQ(read_mesh(folder / "mesh.stl").error().kind, ErrorKind::call) << "STL is only written";
    EXPECT_EQ(write_mesh(shapes::cube(), folder / "mesh.swc").error().kind, ErrorKind::call);
    const Result<QuadMesh> missing = read_mesh(folder / "missing.obj");
    EXPECT_EQ(missing.error().kind, ErrorKind::input);
    EXPECT_THAT(missing.error().text(), HasSubstr("missing.obj: cannot be opened"));
}

TEST(MeshFormats, WhatCannotBeWrittenLeavesTheOldFileWhole) {
    const TemporaryFolder folder;
    const std::string path = folder / "mesh.obj";
    ASSERT_TRUE(write_mesh(shapes::cube(), path));
    const std::string before = *read_file(path);
    QuadMesh broken = shapes::cube();
    broken.positions[5].z() = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(error_text(write_mesh(broken, path)), HasSubstr("vertex 5 of the mesh is not finite"));
    broken = shapes::cube();
    broken.corners[0] = 8;
    EXPECT_EQ(write_mesh(broken, path).error().kind, ErrorKind::call);
    EXPECT_EQ(*read_file(path), before);
}

}  // namespace
}  // namespace sinew
