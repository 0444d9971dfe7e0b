#include "sinew/io/gltf_writer.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/mesh_testing.h"
#include "io/temporary_folder.h"
#include "sinew/io/byte_order.h"
#include "sinew/io/files.h"

namespace sinew {
namespace {

QuadMesh all_kinds_of_faces() {
    QuadMesh mesh = shapes::together(shapes::tube(4, 9), shapes::moved(shapes::cube(), {5, 0, 0}));
    mesh.positions.emplace_back(9.0f, 9.0f, 9.0f);  // of no face
    return mesh;
}

TEST(GltfWriter, KhronosValidatorHasNothingAgainstIt) {
    const std::filesystem::path modules =
        std::filesystem::path(SINEW_SOURCE_FOLDER) / "build/npm/node_modules";
    if (!std::filesystem::exists(modules / "gltf-validator"))
        GTEST_SKIP() << "no gltf-validator in " << modules << ": tools/test installs it";
    const TemporaryFolder folder;
    std::string files;
    for (const QuadMesh& mesh :
         {shapes::cube(), all_kinds_of_faces(), shapes::sphere(9), shapes::octahedron()}) {
        const std::string path = folder / std::to_string(files.size());
        ASSERT_TRUE(write_file(path + ".glb", *glb_bytes(mesh)));
        ASSERT_TRUE(write_file(path + ".gltf", *gltf_text(mesh, 0.001)));
        files += " " + path + ".glb " + path + ".gltf";
    }
    const std::string script = SINEW_SOURCE_FOLDER "/tests/io/validate_gltf.js";
    EXPECT_EQ(std::system(("node " + script + " " + modules.string() + files).c_str()), 0);
    ASSERT_TRUE(write_file(folder / "bad.glb", glb_bytes(shapes::cube())->substr(0, 900)));
    EXPECT_NE(
        std::system(
            ("node " + script + " " + modules.string() + " " + (folder / "bad.glb") + " >/dev/null").c_str()),
        0)
        << "a validator that takes anything shows nothing";
}

TEST(GltfWriter, BothKindsHoldTheSameJsonAndData) {
    const QuadMesh mesh = shapes::tube(3, 4);
    const std::string glb = *glb_bytes(mesh);
    const auto json_size = get_bytes<std::uint32_t>(glb.data() + 12, std::endian::little);
    EXPECT_EQ(glb.size(), get_bytes<std::uint32_t>(glb.data() + 8, std::endian::little));
    const auto binary = nlohmann::json::parse(glb.substr(20, json_size));
    auto text = nlohmann::json::parse(*gltf_text(mesh));
    const std::string uri = text["buffers"][0]["uri"];
    text["buffers"][0].erase("uri");
    EXPECT_EQ(binary, text);
    const std::size_t size = binary["buffers"][0]["byteLength"], start = uri.find(',') + 1;
    EXPECT_EQ(glb.size(), 28 + json_size + size);
    EXPECT_EQ(uri.size() - start, (size + 2) / 3 * 4);
}

}  // namespace
}  // namespace sinew
