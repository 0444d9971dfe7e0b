/// @file split.h
/// Sharp edges for formats that know one normal a vertex only.
#pragma once

#include "sinew/mesh/quad_mesh.h"

namespace sinew {

/// Takes vertices apart along creases of sharpness 1 and above, so that the faces on either side of a sharp
/// edge have vertices (and normals) of their own. Faces keep their order; a vertex keeps its index, and its
/// copies come behind all others. Where a crease ends nothing is taken apart. Features and where vertices
/// came from are lost; weld.h undoes it. The mesh must be well formed (topology.h).
QuadMesh split_at_creases(const QuadMesh& mesh);

}  // namespace sinew
