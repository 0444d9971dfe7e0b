/// @file ngon_encoding.h
/// Polygons in lists of triangles: the glTF extension FB_ngon_encoding.
///
/// A polygon is a fan: a run of triangles with the same first vertex. Two polygons that follow each other do
/// not start with the same vertex; that is how one knows where a polygon ends.
#pragma once

#include "sinew/mesh/triangulate.h"

namespace sinew {

inline constexpr std::string_view ngon_extension = "FB_ngon_encoding";

/// The mesh as triangles in that order. A polygon that is no fan, or cannot start with another vertex than
/// the one before it, comes as single triangles.
std::vector<Triangle> encode_ngons(const QuadMesh& mesh);

/// Appends the polygons of a list of triangles to the faces of a mesh.
void decode_ngons(std::span<const Triangle> triangles, QuadMesh& mesh);

}  // namespace sinew
