#include "sinew/io/gltf_text.h"

#include <fmt/format.h>

#include <array>
#include <utility>
#include <vector>

#include "sinew/io/byte_order.h"

namespace sinew {
namespace {

constexpr const char* export_again = "export the file again";

std::uint32_t version_of_glb(std::string_view bytes) {
    return get_bytes<std::uint32_t>(bytes.data() + 4, std::endian::little);
}

/// The JSON text of a binary file: a header of 12 bytes, then chunks, the first of which is it.
Result<std::string_view> json_of_glb(std::string_view bytes) {
    auto word = [&](std::size_t at) {
        return get_bytes<std::uint32_t>(bytes.data() + at, std::endian::little);
    };
    constexpr std::uint32_t json_chunk = 0x4E4F534A;
    if (bytes.size() < 20)
        return fail(ErrorKind::input, "the file ends within its header", "get the whole file");
    if (word(16) != json_chunk)
        return fail(ErrorKind::input, "the first chunk is not the JSON", export_again);
    if (word(12) > bytes.size() - 20)
        return fail(ErrorKind::input, "the file ends within its JSON", "get the whole file");
    return bytes.substr(20, word(12));
}

Result<std::string_view> json_of(std::string_view bytes) {
    return bytes.starts_with("glTF") ? json_of_glb(bytes) : Result<std::string_view>(bytes);
}

Result<void> check_version(const Json& root) {
    const Json* asset = root.is_object() ? find(root, "asset") : nullptr;
    const Json* version = asset && asset->is_object() ? find(*asset, "version") : nullptr;
    if (!version || !version->is_string() || !version->get<std::string>().starts_with("2."))
        return gltf_fault("/asset/version", "this is JSON, but no glTF of version 2",
                          "export it as glTF 2.0");
    return {};
}

struct RequiredKeys {
    const char* list;
    std::vector<const char*> keys;
};

/// What the specification requires of the objects that are looked at here.
const std::array<RequiredKeys, 7>& required() {
    static const std::array<RequiredKeys, 7> table{{{"buffers", {"byteLength"}},
                                                    {"bufferViews", {"buffer", "byteLength"}},
                                                    {"accessors", {"componentType", "count", "type"}},
                                                    {"meshes", {"primitives"}},
                                                    {"nodes", {}},
                                                    {"scenes", {}},
                                                    {"skins", {"joints"}}}};
    return table;
}

Result<void> check_lists(const Json& root) {
    for (const auto& [list, keys] : required()) {
        const Json* value = find(root, list);
        if (!value) continue;
        if (!value->is_array()) return gltf_fault(fmt::format("/{}", list), "this must be an array");
        for (std::size_t i = 0; i < value->size(); ++i) {
            const std::string pointer = fmt::format("/{}/{}", list, i);
            if (!(*value)[i].is_object()) return gltf_fault(pointer, "this must be an object");
            for (const char* key : keys)
                if (!find((*value)[i], key)) return gltf_fault(pointer, fmt::format("it has no {}", key));
        }
    }
    return {};
}

bool is_plain_surface(const Json& primitive) {
    if (!primitive.is_object()) return true;  // which reading will complain about
    constexpr std::int64_t triangles = 4;
    const Json* mode = find(primitive, "mode");
    if (mode && integer_in(*mode).value_or(triangles) < triangles) return false;
    const Json* extensions = find(primitive, "extensions");
    if (!extensions || !extensions->is_object()) return true;
    return !find(*extensions, "KHR_draco_mesh_compression") && !find(*extensions, "EXT_meshopt_compression");
}

}  // namespace

Error broken_gltf(Error error, std::string_view bytes) {
    if (error.kind != ErrorKind::input) return error;
    error.message = "the glTF file is broken: " + error.message;
    if (error.cure.empty()) error.cure = export_again;
    if (bytes.starts_with("glTF"))
        error.line = error.column = 0;  // nobody looks for lines there
    else if (!bytes.empty() && error.line == 0 && !error.path.empty())
        error.line = line_of(bytes, error.path);
    return error;
}

tl::unexpected<Error> gltf_fault(std::string pointer, std::string message, std::string cure) {
    return fail(Error{.message = std::move(message), .cure = std::move(cure), .path = std::move(pointer)});
}

Result<Json> parse_gltf_text(std::string_view bytes) {
    if (bytes.starts_with("glTF") && bytes.size() >= 8 && version_of_glb(bytes) != 2)
        return fail(ErrorKind::input, fmt::format("this is glTF of version {}", version_of_glb(bytes)),
                    "export it as glTF 2.0");
    const Result<std::string_view> text = json_of(bytes);
    if (!text) return fail(broken_gltf(text.error(), bytes));
    Result<Json> json = parse_json(*text);
    if (!json) return fail(broken_gltf(std::move(json.error()), bytes));
    if (Result<void> version = check_version(*json); !version) {
        Error& error = version.error();  // another file, but not a broken one
        if (!bytes.starts_with("glTF")) error.line = line_of(bytes, error.path);
        return fail(std::move(error));
    }
    if (Result<void> sound = check_lists(*json); !sound)
        return fail(broken_gltf(std::move(sound.error()), bytes));
    return json;
}

Result<bool> gltf_holds_mesh(std::string_view bytes) {
    const Result<Json> json = parse_gltf_text(bytes);
    if (!json) return fail(json.error());
    for (const Json& mesh : array_in(*json, "meshes"))
        for (const Json& primitive : array_in(mesh, "primitives"))
            if (is_plain_surface(primitive)) return true;
    return false;
}

const Json& array_in(const Json& object, const char* key) {
    static const Json none = Json::array();
    const Json* value = object.is_object() ? find(object, key) : nullptr;
    return value && value->is_array() ? *value : none;
}

}  // namespace sinew
