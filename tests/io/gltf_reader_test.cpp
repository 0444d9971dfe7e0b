#include "sinew/io/gltf_reader.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "io/mesh_testing.h"
#include "io/temporary_folder.h"
#include "sinew/io/byte_order.h"
#include "sinew/io/files.h"
#include "sinew/io/gltf_writer.h"
#include "sinew/mesh/measure.h"

namespace sinew {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

/// Positions and faces are the same; a face may start with another corner.
void expect_same_faces(const QuadMesh& read, const QuadMesh& written) {
    EXPECT_EQ(read.positions, written.positions);
    ASSERT_EQ(read.face_offsets, written.face_offsets);
    for (std::size_t f = 0; f < written.face_count(); ++f) {
        std::vector<std::uint32_t> face(written.face(f).begin(), written.face(f).end());
        std::rotate(face.begin(), std::find(face.begin(), face.end(), read.face(f)[0]), face.end());
        EXPECT_TRUE(std::equal(face.begin(), face.end(), read.face(f).begin()));
    }
}

/// A file of ours, taken apart so that a test can change it.
struct Gltf {
    json text;
    std::string data;

    explicit Gltf(const QuadMesh& mesh) {
        const std::string glb = *glb_bytes(mesh);
        const auto size = get_bytes<std::uint32_t>(glb.data() + 12, std::endian::little);
        text = json::parse(glb.substr(20, size));
        data = glb.substr(28 + size);
    }
    std::string bytes() const {
        std::string words = text.dump();
        words.resize((words.size() + 3) / 4 * 4, ' ');
        std::string glb(20, '\0');
        const std::uint32_t sizes[] = {static_cast<std::uint32_t>(28 + words.size() + data.size()),
                                       static_cast<std::uint32_t>(words.size()),
                                       static_cast<std::uint32_t>(data.size())};
        put_little_endian(glb.data(), std::uint32_t{0x46546C67});
        put_little_endian(glb.data() + 4, std::uint32_t{2});
        put_little_endian(glb.data() + 8, sizes[0]);
        put_little_endian(glb.data() + 12, sizes[1]);
        put_little_endian(glb.data() + 16, std::uint32_t{0x4E4F534A});
        glb += words;
        std::string chunk(8, '\0');
        put_little_endian(chunk.data(), sizes[2]);
        put_little_endian(chunk.data() + 4, std::uint32_t{0x004E4942});
        return glb + chunk + data;
    }
    json& primitive() { return text["meshes"][0]["primitives"][0]; }
};

TEST(GltfReader, OurFilesComeBackWithTheirQuads) {
    for (const QuadMesh& mesh :
         {shapes::cube(), shapes::tube(5, 7), shapes::torus(6, 9), shapes::octahedron()}) {
        expect_same_faces(*parse_gltf_mesh(*glb_bytes(mesh), "a.glb"), mesh);
        expect_same_faces(*parse_gltf_mesh(*gltf_text(mesh), "a.gltf"), mesh);
    }
}

TEST(GltfReader, SharpEdgesAreShadedSharpAndComeBackWhole) {
    QuadMesh cube = shapes::cube();
    cube.features.creases = {{{4, 5}, 10}, {{5, 7}, 10}, {{7, 6}, 10}, {{6, 4}, 10}};
    const Gltf gltf(cube);
    EXPECT_EQ(gltf.text["accessors"][0]["count"], 12) << "the lid has vertices of its own";
    expect_same_faces(*parse_gltf_mesh(gltf.bytes(), "a.glb"), cube);
}

TEST(GltfReader, UnitsBecomeMetres) {
    const QuadMesh mesh = *parse_gltf_mesh(*glb_bytes(shapes::cube(), 0.25), "a.glb");
    EXPECT_NEAR(measure(mesh).volume, 1.0 / 64, 1e-9);
}

TEST(GltfReader, VerticesThatOthersTookApartAreOneAgain) {
    QuadMesh apart;  // a cube whose faces bring their own vertices, as flat shading needs it
    const QuadMesh cube = shapes::cube();
    for (std::size_t f = 0; f < 6; ++f) {
        std::vector<std::uint32_t> face;
        for (const std::uint32_t v : cube.face(f)) {
            face.push_back(shapes::index_of(apart.vertex_count()));
            apart.positions.push_back(cube.positions[v]);
        }
        apart.add_face(face);
    }
    Gltf gltf(apart);
    EXPECT_EQ(parse_gltf_mesh(gltf.bytes(), "a.glb")->vertex_count(), 24u) << "ours are as they should be";
    gltf.primitive().erase("extras");
    const QuadMesh quads = *parse_gltf_mesh(gltf.bytes(), "a.glb");
    EXPECT_TRUE(validate(quads).solid());
    EXPECT_EQ(measure(quads).quads, 6);
    gltf.primitive().erase("extensions");
    const QuadMesh triangles = *parse_gltf_mesh(gltf.bytes(), "a.glb");
    EXPECT_TRUE(validate(triangles).solid());
    EXPECT_EQ(measure(triangles).triangles, 12);
}

TEST(GltfReader, NodesPlaceMeshesAndMirrorsKeepThemOutward) {
    Gltf gltf(shapes::cube());
    gltf.text["nodes"] = json::parse(R"([
        {"children": [1, 2], "translation": [0, 0, 5], "rotation": [0, 0.70710678118654752, 0, 0.70710678118654752]},
        {"mesh": 0, "scale": [2, 2, 2]},
        {"mesh": 0, "scale": [-1, 1, 1], "translation": [7, 0, 0]},
        {"mesh": 0}])");  // the last one is in no scene
    const QuadMesh mesh = *parse_gltf_mesh(gltf.bytes(), "a.glb");
    EXPECT_EQ(mesh.vertex_count(), 16u);
    EXPECT_TRUE(validate(mesh).solid());
    const Measures m = measure(mesh);
    EXPECT_NEAR(m.volume, 8 + 1, 1e-5);
    // A quarter turn about y takes x to -z and z to x: the first cube is [0,2]^3 turned, 5 along z; and z-up
    // from y-up.
    EXPECT_LT((m.low - Vec3(0, -5, 0)).norm(), 1e-5);
    EXPECT_LT((m.high - Vec3(2, 2, 2)).norm(), 1e-5);
}

TEST(GltfReader, StripsFansAndMissingIndices) {
    const QuadMesh square =
        shapes::from_faces({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}});
    Gltf gltf(square);
    gltf.primitive().erase("indices");
    gltf.primitive().erase("extensions");
    gltf.primitive()["mode"] = 5;
    expect_same_mesh(*parse_gltf_mesh(gltf.bytes(), "a.glb"),
                     shapes::from_faces(square.positions, {{0, 1, 2}, {2, 1, 3}}));
    gltf.primitive()["mode"] = 6;
    EXPECT_EQ(parse_gltf_mesh(gltf.bytes(), "a.glb")->corners,
              (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
    gltf.primitive()["mode"] = 1;
    EXPECT_THAT(error_text(parse_gltf_mesh(gltf.bytes(), "a.glb")),
                HasSubstr("there are no triangles in it"));
}

TEST(GltfReader, SmallIntegersMayStandForPositions) {
    // KHR_mesh_quantization: three corners of a triangle as normalised bytes, each item four bytes apart.
    Gltf gltf(shapes::from_faces({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
    const char bytes[] = {0, 0, 0, 9, 127, 0, 0, 9, 0, -127, 0, 9};
    gltf.data.replace(0, sizeof bytes, bytes, sizeof bytes);
    gltf.text["accessors"][0] = {
        {"bufferView", 0}, {"componentType", 5120}, {"normalized", true}, {"count", 3}, {"type", "VEC3"}};
    gltf.text["bufferViews"][0]["byteStride"] = 4;
    const QuadMesh mesh = *parse_gltf_mesh(gltf.bytes(), "a.glb");
    EXPECT_EQ(mesh.positions, (std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, -1, 0}}));
}

TEST(GltfReader, SparseValuesReplaceOthers) {
    Gltf gltf(shapes::from_faces({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}));
    std::string more(16, '\0');  // the vertex 2, and where it goes
    put_little_endian(more.data(), 5.0f);
    put_little_endian(more.data() + 12, std::uint32_t{2});
    gltf.text["buffers"][0]["byteLength"] = gltf.data.size() + more.size();
    gltf.text["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", gltf.data.size()}, {"byteLength", 16}});
    gltf.data += more;
    gltf.text["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", 3}, {"byteOffset", 12}, {"componentType", 5125}}},
        {"values", {{"bufferView", 3}}}};
    EXPECT_EQ(parse_gltf_mesh(gltf.bytes(), "a.glb")->positions[2], Vec3f(5, 0, 0));
}

TEST(GltfReader, BuffersAreTakenFromBesideTheFileOnly) {
    Gltf gltf(shapes::cube());
    const TemporaryFolder folder;
    ASSERT_TRUE(write_file(folder / "cube data.bin", gltf.data));
    gltf.text["buffers"][0]["uri"] = "cube%20data.bin";
    EXPECT_EQ(error_text(parse_gltf_mesh(gltf.text.dump(), folder / "a.gltf")), "");
    std::filesystem::create_directory(folder.path() / "below");
    std::filesystem::create_symlink(folder / "cube data.bin", folder / "below/link.bin");
    for (const std::string uri :
         {std::string("missing.bin"), std::string("../cube data.bin"), std::string("%2e%2e/cube%20data.bin"),
          folder / "cube data.bin", std::string("link.bin")}) {
        gltf.text["buffers"][0]["uri"] = uri;
        EXPECT_THAT(error_text(parse_gltf_mesh(gltf.text.dump(), folder / "below/a.gltf")),
                    HasSubstr("/buffers/0/uri: names the file '"))
            << uri;
    }
    gltf.text["buffers"][0]["uri"] = "cube%20data.bin";
    EXPECT_THAT(error_text(parse_gltf_mesh(gltf.text.dump(), "standard input")),
                HasSubstr("what comes from standard input may name none"));
}

TEST(GltfReader, AShortBufferFileIsRefusedWithoutItsSize) {
    Gltf gltf(shapes::cube());
    const TemporaryFolder folder;
    ASSERT_TRUE(write_file(folder / "a.bin", gltf.data + "and more, which does no harm"));
    gltf.text["buffers"][0]["uri"] = "a.bin";
    EXPECT_EQ(error_text(parse_gltf_mesh(gltf.text.dump(), folder / "a.gltf")), "");
    ASSERT_TRUE(write_file(folder / "a.bin", gltf.data.substr(1)));
    const std::string text = error_text(parse_gltf_mesh(gltf.text.dump(), folder / "a.gltf"));
    EXPECT_THAT(text, HasSubstr("ends too early"));
    EXPECT_THAT(text, Not(HasSubstr(std::to_string(gltf.data.size() - 1))));
}

TEST(GltfReader, ImagesAreNotOpened) {
    Gltf gltf(shapes::cube());
    const TemporaryFolder folder;
    gltf.text["images"] = {{{"uri", "none.png"}}, {{"uri", "/etc/passwd"}}, {{"uri", "../up.png"}}};
    EXPECT_EQ(
        error_text(parse_gltf_mesh(gltf.text.dump(), folder / "a.glb")),
        folder / "a.glb: /buffers/0: the glTF file is broken: the buffer has no uri; export the file again");
    EXPECT_EQ(error_text(parse_gltf_mesh(gltf.bytes(), folder / "a.glb")), "");
}

TEST(GltfReader, DeepExtrasAreRefusedBeforeAnythingWalksThem) {
    Gltf gltf(shapes::cube());
    std::string text = gltf.text.dump();
    const int deep = 100'000;
    text.insert(1, "\"extras\": " + std::string(deep, '[') + std::string(deep, ']') + ", ");
    EXPECT_THAT(
        error_text(parse_gltf_mesh(text, "a.gltf")),
        HasSubstr("the glTF file is broken: arrays and objects stand in one another more than 100 deep"));
}

TEST(GltfReader, InstancesMakeNoMoreThanAMultipleOfTheFile) {
    Gltf gltf(shapes::cube());
    const auto instances = [&](int count) {
        gltf.text["nodes"] = json::array();
        gltf.text["scenes"][0]["nodes"] = json::array();
        for (int i = 0; i < count; ++i) {
            gltf.text["nodes"].push_back({{"mesh", 0}});
            gltf.text["scenes"][0]["nodes"].push_back(i);
        }
        return parse_gltf_mesh(gltf.bytes(), "a.glb");
    };
    EXPECT_EQ(instances(1000)->vertex_count(), 8000u);
    // A hundred primitives that share their data, shown a thousand times each.
    json& primitives = gltf.text["meshes"][0]["primitives"];
    for (int i = 0; i < 99; ++i) primitives.push_back(json(primitives[0]));
    EXPECT_THAT(error_text(instances(1000)), HasSubstr("too many for"));
}

TEST(GltfReader, BrokenReferencesAreRefusedWithTheirPlace) {
    const auto refused = [](const std::function<void(Gltf&)>& change) {
        Gltf gltf(shapes::cube());
        change(gltf);
        return error_text(parse_gltf_mesh(gltf.bytes(), "bad.glb"));
    };
    EXPECT_THAT(refused([](Gltf& g) { g.primitive()["attributes"]["POSITION"] = 7; }),
                HasSubstr("bad.glb: /accessors/7"));
    EXPECT_THAT(refused([](Gltf& g) { g.primitive()["indices"] = 0; }),
                HasSubstr("/accessors/0: the glTF file is broken: 3 numbers an item, not 1"));
    EXPECT_THAT(refused([](Gltf& g) { g.primitive()["attributes"].erase("POSITION"); }),
                HasSubstr("it has no positions"));
    EXPECT_THAT(refused([](Gltf& g) { g.text["accessors"][0]["count"] = 9; }),
                HasSubstr("lead out of the buffer"));
    EXPECT_THAT(refused([](Gltf& g) { g.text["accessors"][0]["byteOffset"] = 1u << 30; }),
                HasSubstr("lead out of the buffer"));
    EXPECT_THAT(refused([](Gltf& g) { g.text["bufferViews"][0]["byteLength"] = 1u << 30; }),
                HasSubstr("lead out of the buffer"));
    EXPECT_THAT(refused([](Gltf& g) { g.text["bufferViews"][0]["buffer"] = 3; }),
                HasSubstr("bad.glb: /bufferViews/0"));
    EXPECT_THAT(refused([](Gltf& g) { g.text["accessors"][0].erase("bufferView"); }),
                HasSubstr("without data of its own"));
    EXPECT_THAT(refused([](Gltf& g) { g.text["nodes"][0]["mesh"] = 4; }),
                HasSubstr("/meshes/4: the glTF file is broken: there is no such mesh"));
    EXPECT_THAT(refused([](Gltf& g) { g.text["nodes"][0]["children"] = {0}; }),
                HasSubstr("its own ancestor"));
    EXPECT_THAT(refused([](Gltf& g) { g.text["scenes"][0]["nodes"] = {5}; }),
                HasSubstr("there is no such node"));
    EXPECT_THAT(refused([](Gltf& g) { put_little_endian(g.data.data() + 2 * 96, std::uint32_t{8}); }),
                HasSubstr("a triangle names vertex 8, but there are 8"));
    EXPECT_THAT(refused([](Gltf& g) { put_little_endian(g.data.data(), std::uint32_t{0x7f800000}); }),
                HasSubstr("vertex 0 is not finite"));
    EXPECT_THAT(refused([](Gltf& g) {
                    g.primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}};
                }),
                HasSubstr("packed with KHR_draco_mesh_compression"));
    EXPECT_THAT(refused([](Gltf& g) {
                    g.primitive().erase("extras");
                    std::fill(g.data.begin(), g.data.begin() + 96, '\0');
                }),
                HasSubstr("no triangles"))
        << "all corners at one place";
    EXPECT_THAT(error_text(parse_gltf_mesh("{\"asset\": {\"version\": \"2.0\"}}", "bad.gltf")),
                HasSubstr("no triangles"));
    EXPECT_THAT(error_text(parse_gltf_mesh("solid", "bad.gltf")),
                HasSubstr("bad.gltf:1:1: the glTF file is broken: this is not JSON"));
}

TEST(GltfReader, OnlyTheWholeOfAFileIsRead) {
    auto read = [](std::string_view prefix) { return parse_gltf_mesh(prefix, "cut"); };
    EXPECT_EQ(read_prefixes(*glb_bytes(shapes::cube()), read), 0u);
    EXPECT_LE(read_prefixes(*gltf_text(shapes::cube()), read), 1u) << "the last line end may be missing";
}

}  // namespace
}  // namespace sinew
