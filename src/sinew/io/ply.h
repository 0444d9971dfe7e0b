/// @file ply.h
/// Stanford PLY: polygons as they are, positions and faces only.
#pragma once

#include "sinew/io/ply_header.h"
#include "sinew/mesh/quad_mesh.h"

namespace sinew {

/// Reads x, y, z of the element `vertex` and the list `vertex_indices` (or `vertex_index`) of the element
/// `face`, in any of the three encodings, with any types and any other elements and properties between them.
/// Fails, with the line (ascii) or the vertex or face (binary), for what is cut off, no number, not finite or
/// no vertex, for faces of fewer than three corners, and where there is no face at all.
/// @param name  of the file, for messages
Result<QuadMesh> parse_ply(std::string_view bytes, const std::string& name);

/// The mesh as the bytes of a PLY file: float x, y, z and lists of int (ascii: in the shortest form that
/// reads back alike). The mesh must be well formed (topology.h) and have fewer than 2^31 vertices.
std::string ply_bytes(const QuadMesh& mesh, PlyEncoding encoding = PlyEncoding::little_endian);

}  // namespace sinew
