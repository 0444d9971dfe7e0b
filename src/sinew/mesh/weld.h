/// @file weld.h
/// Vertices that were one before a format took them apart.
#pragma once

#include "sinew/mesh/quad_mesh.h"

namespace sinew {

/// Makes one vertex of all that lie at exactly the same position (the first of them), and leaves out vertices
/// of no face, corners that repeat the one before them, and faces that have fewer than three corners then.
/// Vertices and faces keep their order; features and where vertices came from are lost. The mesh must be well
/// formed (topology.h) and finite.
QuadMesh welded(const QuadMesh& mesh);

}  // namespace sinew
