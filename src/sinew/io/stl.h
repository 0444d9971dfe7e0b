/// @file stl.h
/// Binary STL, for printing: triangles that share nothing.
#pragma once

#include <string>

#include "sinew/mesh/quad_mesh.h"

namespace sinew {

/// The mesh, cut into triangles (triangulate.h), as the bytes of a binary STL file. Normals are those of the
/// triangles, zero where a triangle has none. The mesh must be well formed (topology.h).
std::string stl_bytes(const QuadMesh& mesh);

}  // namespace sinew
