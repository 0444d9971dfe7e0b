/// @file name_drawn.h
/// Which drawn node and bone each vertex is from, where the skeleton was completed by its symmetry.
#pragma once

#include "sinew/mesh/quad_mesh.h"
#include "sinew/skeleton/document.h"
#include "sinew/skeleton/symmetry.h"

namespace sinew::sqm {

/// In: a mesh whose vertices name nodes and bones of the expanded document. Out: those of the drawn document
/// that these are images of; -1 for a bone that has no drawn one, as from a node to its own image.
void name_drawn(const Document& drawn, const ExpandedSymmetry& expanded, QuadMesh& mesh);

}  // namespace sinew::sqm
