#include "sinew/io/gltf_writer.h"

#include <tbb/parallel_for.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "sinew/io/byte_order.h"
#include "sinew/io/ngon_encoding.h"
#include "sinew/io/text_numbers.h"
#include "sinew/mesh/normals.h"
#include "sinew/mesh/split.h"

namespace sinew {
namespace {

using Json = nlohmann::ordered_json;

// Numbers that the specification gives these names.
constexpr int type_float = 5126, type_uint32 = 5125, target_vertices = 34962, target_indices = 34963,
              mode_triangles = 4;

void append_vectors(const std::vector<Vec3f>& vectors, std::string& bytes) {
    append_items(
        bytes, vectors.size(), [](std::size_t begin, std::size_t end) { return 12 * (end - begin); },
        [&](std::size_t begin, std::size_t end, char* at) {
            for (std::size_t i = begin; i < end; ++i)
                for (const float value : vectors[i]) at = put_little_endian(at, value);
            return at;
        });
}

void append_triangles(const std::vector<Triangle>& triangles, std::string& bytes) {
    append_items(
        bytes, triangles.size(), [](std::size_t begin, std::size_t end) { return 12 * (end - begin); },
        [&](std::size_t begin, std::size_t end, char* at) {
            for (std::size_t i = begin; i < end; ++i)
                for (const std::uint32_t vertex : triangles[i]) at = put_little_endian(at, vertex);
            return at;
        });
}

Json three(const Vec3f& v) { return {v.x(), v.y(), v.z()}; }

Json accessor(int view, int component, std::size_t count, const char* type) {
    return {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}};
}

/// What a mesh is made of, and where it lies in the buffer.
Json describe(const QuadMesh& mesh, std::size_t triangles, bool shared, double metres_a_unit) {
    Eigen::AlignedBox3f box;
    for (const Vec3f& p : mesh.positions) box.extend(p);
    const std::size_t vertices = mesh.vertex_count(), vertex_bytes = 12 * vertices,
                      index_bytes = 12 * triangles;
    const double s = metres_a_unit;
    Json json;
    json["asset"] = {{"version", "2.0"}, {"generator", "Sinew"}};
    json["extensionsUsed"] = {ngon_extension};
    json["scene"] = 0;
    json["scenes"] = Json::array({{{"nodes", {0}}}});
    json["nodes"] = Json::array(
        {{{"name", "sinew"}, {"mesh", 0}, {"matrix", {s, 0, 0, 0, 0, 0, -s, 0, 0, s, 0, 0, 0, 0, 0, 1}}}});
    json["materials"] = Json::array(
        {{{"name", "clay"},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {0.8, 0.8, 0.8, 1}}, {"metallicFactor", 0}, {"roughnessFactor", 0.6}}}}});
    json["meshes"] =
        Json::array({{{"name", "sinew"},
                      {"primitives", Json::array({{{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}},
                                                   {"indices", 2},
                                                   {"material", 0},
                                                   {"mode", mode_triangles},
                                                   {"extensions", {{ngon_extension, Json::object()}}},
                                                   {"extras", {{"shared_vertices", shared}}}}})}}});
    Json positions = accessor(0, type_float, vertices, "VEC3");
    positions["min"] = three(box.min());
    positions["max"] = three(box.max());
    json["accessors"] = {positions, accessor(1, type_float, vertices, "VEC3"),
                         accessor(2, type_uint32, 3 * triangles, "SCALAR")};
    auto view = [](std::size_t offset, std::size_t length, int target) {
        return Json{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}, {"target", target}};
    };
    json["bufferViews"] = {view(0, vertex_bytes, target_vertices),
                           view(vertex_bytes, vertex_bytes, target_vertices),
                           view(2 * vertex_bytes, index_bytes, target_indices)};
    json["buffers"] = Json::array({{{"byteLength", 2 * vertex_bytes + index_bytes}}});
    return json;
}

struct Parts {
    Json json;
    std::string data;
};

Result<Parts> parts_of(const QuadMesh& whole, double metres_a_unit) {
    const bool shared = whole.features.creases.empty();
    const QuadMesh split = shared ? QuadMesh{} : split_at_creases(whole);
    const QuadMesh& mesh = shared ? whole : split;
    const std::vector<Triangle> triangles = encode_ngons(mesh);
    if (24 * mesh.vertex_count() + 12 * triangles.size() > std::numeric_limits<std::uint32_t>::max() - 4096)
        return fail(ErrorKind::call, "the mesh is too large for glTF, which holds 4 GiB",
                    "write PLY instead");
    Parts parts{describe(mesh, triangles.size(), shared, metres_a_unit), {}};
    append_vectors(mesh.positions, parts.data);
    append_vectors(vertex_normals(mesh), parts.data);
    append_triangles(triangles, parts.data);
    return parts;
}

void append_number(std::string& bytes, std::size_t number) {
    char four[4];
    put_little_endian(four, static_cast<std::uint32_t>(number));
    bytes.append(four, 4);
}

void append_chunk(std::string& bytes, std::string_view kind, const std::string& chunk) {
    append_number(bytes, chunk.size());
    bytes += kind;
    bytes += chunk;
}

std::string base64(const std::string& bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text((bytes.size() + 2) / 3 * 4, '=');
    auto at = [&](std::size_t i) { return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0u; };
    for (std::size_t i = 0, o = 0; i < bytes.size(); i += 3, o += 4) {
        const unsigned three_bytes = at(i) << 16 | at(i + 1) << 8 | at(i + 2);
        const std::size_t count = std::min<std::size_t>(4, bytes.size() - i + 1);
        for (std::size_t k = 0; k < count; ++k) text[o + k] = digits[three_bytes >> (18 - 6 * k) & 63];
    }
    return text;
}

}  // namespace

Result<std::string> glb_bytes(const QuadMesh& mesh, double metres_a_unit) {
    const Result<Parts> parts = parts_of(mesh, metres_a_unit);
    if (!parts) return tl::unexpected(parts.error());
    std::string json = parts->json.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string bytes = "glTF";  // all our data come in fours: they need no padding
    bytes.reserve(28 + json.size() + parts->data.size());
    append_number(bytes, 2);
    append_number(bytes, 28 + json.size() + parts->data.size());
    append_chunk(bytes, "JSON", json);
    append_chunk(bytes, std::string_view("BIN\0", 4), parts->data);
    return bytes;
}

Result<std::string> gltf_text(const QuadMesh& mesh, double metres_a_unit) {
    Result<Parts> parts = parts_of(mesh, metres_a_unit);
    if (!parts) return tl::unexpected(parts.error());
    // The JSON library would look at each of millions of characters: they take the place of a short word
    // afterwards.
    const std::string place = "data follow here";
    parts->json["buffers"][0]["uri"] = place;
    std::string text = parts->json.dump(2) + "\n";
    return text.replace(text.find(place), place.size(),
                        "data:application/octet-stream;base64," + base64(parts->data));
}

}  // namespace sinew
