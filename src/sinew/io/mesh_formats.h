/// @file mesh_formats.h
/// Meshes from and to files, whatever their format.
#pragma once

#include <string>
#include <string_view>

#include "sinew/base/result.h"
#include "sinew/io/formats.h"
#include "sinew/mesh/quad_mesh.h"

namespace sinew {

/// Reads a mesh; "-" is standard input.
/// @param format  a name of the table (formats.h); empty: by the extension of the path
/// The mesh is well formed (topology.h) and finite, and its faces have three corners or more; it need not be
/// closed or anything else: validate.h tells.
Result<QuadMesh> read_mesh(const std::string& path, std::string_view format = {});

/// The same from the bytes of a file; `name` is the file's, for messages and for files beside it (buffers of
/// a .gltf).
Result<QuadMesh> parse_mesh(std::string_view bytes, FormatName format, const std::string& name);

/// Is a file of a format that may hold meshes, skeletons or both (glTF) one with a mesh? For other formats of meshes
/// that is certain, and no file is read. Fails where the file cannot be read or is broken.
Result<bool> holds_mesh(const std::string& path, std::string_view format = {});

struct MeshWriteOptions {
    std::string format;        ///< a name of the table; empty: by the extension of the path
    bool ascii = false;        ///< PLY as text
    double metres_a_unit = 1;  ///< glTF and USD say how long a unit is; > 0
};

/// Writes a mesh in one piece (files.h); "-" is standard output. The same mesh gives the same bytes, always.
/// Fails, as the call's fault, for a mesh that is not well formed or not finite.
Result<void> write_mesh(const QuadMesh& mesh, const std::string& path, const MeshWriteOptions& options = {});

/// The same as the bytes of the file.
Result<std::string> mesh_bytes(const QuadMesh& mesh, FormatName format, const MeshWriteOptions& options = {});

}  // namespace sinew
