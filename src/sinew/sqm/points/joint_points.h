/// @file joint_points.h
/// The vertices of the mesh at the joints: where cells meet, and along the arcs between them.
///
/// Each lies on the joint's surface, in its own direction from the joint's centre, so a joint never folds
/// over itself. The surface is that of the round cones of its bones, or of the ball or box that the joint is,
/// less its pits.
#pragma once

#include <cstdint>
#include <vector>

#include "sinew/sqm/counts/refine.h"
#include "sinew/sqm/surface/joint_surface.h"

namespace sinew::sqm {

struct JointPoints {
    std::vector<std::uint32_t> first;      ///< joint -> its first point; joints + 1 entries
    std::vector<std::uint32_t> arc_first;  ///< arc -> the first of its pieces - 1 inner points
    std::vector<Vec3> position;  ///< joint by joint: its vertices in order, then the inner points arc by arc
};

JointPoints make_joint_points(const Plain& skeleton, const Network& network, const Polyhedra& polyhedra,
                              const Refinement& refinement, const JointSurfaces& surfaces);

/// visit(point) for the points round a cell, counter-clockwise seen from outside. The first one is a joint's
/// vertex.
template <class Visit>
void for_ring(const Polyhedra& polyhedra, const Refinement& refinement, const JointPoints& points,
              std::int32_t joint, std::int32_t cell, Visit visit) {
    const std::uint32_t corners = points.first[joint] - polyhedra.vertex_first[joint];
    for (const CellSide& side : polyhedra.cell(cell)) {
        const CellArc& arc = polyhedra.arcs[side.arc];
        const std::uint32_t first = points.arc_first[side.arc], end = first + refinement.pieces[side.arc] - 1;
        visit(corners + (side.reversed ? arc.to : arc.from));
        if (side.reversed)
            for (std::uint32_t i = end; i > first; --i) visit(i - 1);
        else
            for (std::uint32_t i = first; i < end; ++i) visit(i);
    }
}

}  // namespace sinew::sqm
