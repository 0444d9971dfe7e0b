/// @file path_needs.h
/// How many vertices every path needs round it before its joints have agreed on anything.
///
/// In: forms of its nodes, the cells and the symmetry of its joints. Out: for each path the least count, and
/// what the count must be a multiple of: 4 where rings have four corners (boxes, rectangular sections), the
/// order of a symmetry that turns the path about itself, 8 where an outline with corners lies across a
/// mirror. Linear; cannot fail.
#pragma once

#include <cstdint>
#include <vector>

#include "sinew/sqm/cells/images.h"
#include "sinew/sqm/surface/joint_surface.h"

namespace sinew::sqm {

struct PathNeeds {
    std::vector<std::int32_t> least;    ///< path -> vertices round it at least, a multiple of its step
    std::vector<std::int32_t> step;     ///< path -> its count is a multiple of this
    std::vector<std::uint8_t> corners;  ///< path -> its rings have four corners
    std::vector<std::int32_t> pieces;   ///< arc -> its least pieces; empty where there is a symmetry
};

inline std::int32_t round_up(std::int32_t count, std::int32_t step) {
    return (count + step - 1) / step * step;
}

/// Pieces of all arcs round a cell.
inline std::int32_t sum_of_cell(const Polyhedra& polyhedra, std::int32_t cell,
                                const std::vector<std::int32_t>& pieces) {
    std::int32_t sum = 0;
    for (const CellSide& side : polyhedra.cell(cell)) sum += pieces[side.arc];
    return sum;
}

/// @param sides  what every path has at least
PathNeeds find_path_needs(const Plain& skeleton, const Network& network, const Polyhedra& polyhedra,
                          const JointSurfaces& surfaces, const Images& images, std::int32_t sides);

}  // namespace sinew::sqm
