#include "sinew/io/mesh_formats.h"

#include <fmt/format.h>

#include <exception>

#include "sinew/io/files.h"
#include "sinew/io/gltf_reader.h"
#include "sinew/io/gltf_text.h"
#include "sinew/io/gltf_writer.h"
#include "sinew/io/obj.h"
#include "sinew/io/ply.h"
#include "sinew/io/stl.h"
#include "sinew/io/usda_reader.h"
#include "sinew/io/usda_writer.h"
#include "sinew/mesh/validate.h"

namespace sinew {
namespace {

/// No writer looks out for indices that lead nowhere, and nan has no place in most formats.
Result<void> check_writable(const QuadMesh& mesh) {
    if (!well_formed(mesh))
        return fail(ErrorKind::call, "the mesh has faces that name vertices which do not exist");
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
        if (!mesh.positions[v].allFinite())
            return fail(ErrorKind::call, fmt::format("vertex {} of the mesh is not finite", v));
    return {};
}

Result<QuadMesh> parse(std::string_view bytes, FormatName format, const std::string& name) {
    switch (format) {
        case FormatName::obj:
            return parse_obj(bytes, name);
        case FormatName::ply:
            return parse_ply(bytes, name);
        case FormatName::glb:
        case FormatName::gltf:
            return parse_gltf_mesh(bytes, name);
        case FormatName::usda:
            return parse_usda(bytes, name);
        default:
            return fail(ErrorKind::call, "this format cannot be read as a mesh");
    }
}

Result<std::string> write(const QuadMesh& mesh, FormatName format, const MeshWriteOptions& options) {
    switch (format) {
        case FormatName::obj:
            return obj_text(mesh);
        case FormatName::ply:
            return ply_bytes(mesh, options.ascii ? PlyEncoding::ascii : PlyEncoding::little_endian);
        case FormatName::stl:
            return stl_bytes(mesh);
        case FormatName::glb:
            return glb_bytes(mesh, options.metres_a_unit);
        case FormatName::gltf:
            return gltf_text(mesh, options.metres_a_unit);
        case FormatName::usda:
            return usda_text(mesh, options.metres_a_unit);
        default:
            return fail(ErrorKind::call, "this format cannot be written as a mesh");
    }
}

}  // namespace

Result<QuadMesh> read_mesh(const std::string& path, std::string_view format) {
    const Result<const Format*> chosen = choose_format(path, format, FormatUse::read_mesh);
    if (!chosen) return tl::unexpected(chosen.error());
    const Result<std::string> bytes = read_file(path);
    if (!bytes) return tl::unexpected(bytes.error());
    return parse_mesh(*bytes, (*chosen)->id, path == "-" ? input_name(path) : path);
}

Result<bool> holds_mesh(const std::string& path, std::string_view format) {
    const Result<const Format*> chosen = choose_format(path, format, FormatUse::read_mesh);
    if (!chosen) return tl::unexpected(chosen.error());
    if (!(*chosen)->reads_skeleton) return true;
    const Result<std::string> bytes = read_file(path);
    if (!bytes) return tl::unexpected(bytes.error());
    Result<bool> holds = gltf_holds_mesh(*bytes);
    if (!holds) holds.error().file = input_name(path);
    return holds;
}

Result<QuadMesh> parse_mesh(std::string_view bytes, FormatName format, const std::string& name) try {
    return parse(bytes, format, name);
} catch (const std::exception&) {  // bad_alloc, length_error
    return fail(Error{.message = "is too large for the memory", .file = name});
}

Result<void> write_mesh(const QuadMesh& mesh, const std::string& path, const MeshWriteOptions& options) {
    const Result<const Format*> chosen = choose_format(path, options.format, FormatUse::write_mesh);
    if (!chosen) return tl::unexpected(chosen.error());
    const Result<std::string> bytes = mesh_bytes(mesh, (*chosen)->id, options);
    if (!bytes) return tl::unexpected(bytes.error());
    return write_file(path, *bytes);
}

Result<std::string> mesh_bytes(const QuadMesh& mesh, FormatName format, const MeshWriteOptions& options) try {
    if (auto writable = check_writable(mesh); !writable) return tl::unexpected(writable.error());
    return write(mesh, format, options);
} catch (const std::exception&) {
    return fail(ErrorKind::program, "the mesh is too large for the memory");
}

}  // namespace sinew
