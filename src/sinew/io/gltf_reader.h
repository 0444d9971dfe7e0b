/// @file gltf_reader.h
/// Meshes from glTF 2.0 files.
#pragma once

#include <string>
#include <string_view>

#include "sinew/base/result.h"
#include "sinew/mesh/quad_mesh.h"

namespace sinew {

/// Reads all meshes of the default scene of a .glb or .gltf, placed by their nodes and turned so that z is
/// up. Triangles, strips and fans are read; polygons where they are encoded (ngon_encoding.h). Vertices at
/// exactly the same place are made one (weld.h), since the format takes vertices apart where normals or
/// materials change, but for meshes that say, as ours do, that they are as they should be. Fails, with the
/// place in the file, for what does not exist, is not finite or is compressed, and where no triangle is
/// found. Meshes that are shown many times may come to 16 vertices and corners a byte of the file (and to four
/// million in all); more is refused before it is made.
/// @param name  of the file, for messages and to find buffers beside it
Result<QuadMesh> parse_gltf_mesh(std::string_view bytes, const std::string& name);

}  // namespace sinew
