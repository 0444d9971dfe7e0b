/// @file intersect.h
/// Where does a mesh run through itself?
#pragma once

#include "sinew/base/progress.h"
#include "sinew/base/result.h"
#include "sinew/mesh/quad_mesh.h"

namespace sinew {

using FacePair = std::array<std::uint32_t, 2>;  ///< the lower face first

/// All pairs of faces that meet beyond the vertices and edges they share by index, in ascending order; faces
/// that share nothing do so where they touch, too. Faces are what triangulate.h makes of them; triangles
/// whose points are on one line, and faces with a vertex that is not finite, are left out (measure.h and
/// validate.h tell of them), and so is a face that is folded over itself.
///
/// Signs are exact: neither rounding nor the order of the faces has a say. A bounding-volume hierarchy makes
/// the time near linear in the faces and in the pairs whose boxes overlap. The mesh must be well formed
/// (topology.h). Fails only when it is stopped.
Result<std::vector<FacePair>> find_self_intersections(const QuadMesh& mesh, const Progress& progress = {});

}  // namespace sinew
