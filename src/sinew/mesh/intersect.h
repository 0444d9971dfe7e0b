/// @file intersect.h
/// Where does a mesh run through itself?
#pragma once

#include <array>
#include <cstdint>
#include <vector>

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

struct SelfIntersections {
    std::vector<FacePair> pairs;
    bool complete = true;  ///< false: there may be more, the search was given up where too many boxes overlap
};

/// Pairs of faces or of the boxes round them that are looked at before a search is given up: so many and, for each
/// face, so many more. A sound mesh takes about ten a face.
inline constexpr std::uint64_t most_pairs_tested = 4'000'000, most_pairs_tested_a_face = 256;

/// The same in time and memory that are linear in the faces, however many of them lie over each other: what a mesh
/// of nobody knows whom should be looked at with. The same mesh gives the same pairs.
Result<SelfIntersections> find_self_intersections_within_bounds(const QuadMesh& mesh,
                                                                const Progress& progress = {});

}  // namespace sinew
