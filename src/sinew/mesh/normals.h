/// @file normals.h
/// Vertex normals, for shading.
#pragma once

#include "sinew/mesh/quad_mesh.h"

namespace sinew {

/// A unit normal a vertex, outward as the faces are. Corners are weighted by sine over the product of the
/// edge lengths there, which gives the exact normal where the neighbours lie on a sphere (N. Max, "Weights
/// for computing vertex normals from facet normals", 1999). A vertex without faces, or whose faces cancel
/// each other, gets z. The mesh must be well formed (topology.h).
std::vector<Vec3f> vertex_normals(const QuadMesh& mesh);

}  // namespace sinew
