/// @file refine.h
/// Stage 2: arcs are split so that both ends of every path have rings of the same number of vertices.
///
/// In: network and polyhedra. Out: the number of pieces of every arc and of vertices round every path.
/// Paths on cycles, and those between them, share one even count in each component, the least one that all
/// joints can meet; polyhedra inscribed in a sphere have positive weights with equal sums at the vertices (I.
/// Rivin, "A characterization of ideal polyhedra in hyperbolic 3-space", 1996), so there is one. Trees take
/// what their joints need: counts are passed on from the root of each, or from the cycles that it hangs on,
/// where one cell of each joint is given and all others are free above their own least count. Symmetric
/// skeletons are split symmetrically. Fails only when it is stopped, or if a count beyond any that was ever
/// met is not enough (a fault of the program).
#pragma once

#include <cstdint>
#include <vector>

#include "sinew/base/progress.h"
#include "sinew/sqm/cells/images.h"
#include "sinew/sqm/cells/polyhedra.h"
#include "sinew/sqm/surface/joint_surface.h"

namespace sinew::sqm {

struct RefineOptions {
    int sides = 0;  ///< vertices round every path, or the least possible number above; 0: as few as possible,
                    ///< at least 4
};

struct Refinement {
    std::vector<std::int32_t> pieces;      ///< arc -> pieces, at least 1
    std::vector<std::int32_t> path_sides;  ///< path -> vertices round it, at least 4
};

Result<Refinement> refine(const Plain& skeleton, const Network& network, const Polyhedra& polyhedra,
                          const JointSurfaces& surfaces, const Images& images,
                          const RefineOptions& options = {}, const Progress& progress = {});

}  // namespace sinew::sqm
