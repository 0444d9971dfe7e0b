/// @file polyhedra.h
/// Stage 1: the sphere round each joint is tiled with one cell a bone.
///
/// In: the skeleton and its network. Out: for every joint the spherical Voronoi cells of its bones'
/// directions, the dual of SQM's branch node polyhedron. The edges of the mesh at a joint are the arcs
/// between cells, so a joint owns no faces: every face belongs to a tube. A vertex where k cells meet will
/// have the valence 2k. Cannot fail: coincident, coplanar and cocircular directions have rules of their own
/// (spherical_cells.h). Baerentzen, Misztal, Welnicka, "Converting skeletal structures to quad dominant
/// meshes", C&G 36(5), 2012, section 3.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sinew/base/progress.h"
#include "sinew/sqm/cells/spherical_cells.h"
#include "sinew/sqm/network.h"

namespace sinew::sqm {

/// The cells of all joints, in flat arrays with indices that count through all joints.
/// Cell cell_first[j] + s is that of slot s of joint j; the cells after those of the slots, if any, have no
/// bone: they were added to part crowded vertices and are closed with a fan. The pole of such a fan has as
/// many edges as vertices round its cell, on a star of many bones in a plane one a bone; all other vertices
/// of a joint have at most 12.
struct Polyhedra {
    std::vector<std::int32_t> cell_first, vertex_first,
        arc_first;               ///< joint -> first one; joints + 1 entries
    std::vector<Vec3> sites;     ///< cell -> unit direction in its middle
    std::vector<Vec3> vertices;  ///< unit directions from the joint, of an ellipsoid in its ball space
    std::vector<CellArc> arcs;
    std::vector<std::uint8_t> arc_doubled;  ///< arc -> another one has both its ends in common
    std::vector<std::int32_t> side_first;   ///< cell -> first side; cells + 1 entries
    std::vector<CellSide> sides;

    std::int32_t joint_count() const { return static_cast<std::int32_t>(cell_first.size()) - 1; }
    std::int32_t cell_count() const { return static_cast<std::int32_t>(sites.size()); }
    std::span<const CellSide> cell(std::int32_t c) const {
        return {sides.data() + side_first[c], sides.data() + side_first[c + 1]};
    }
};

/// Direction in which a bone leaves a joint: to the next node of its path.
Vec3 slot_direction(const Plain& skeleton, const Network& network, std::int32_t joint, std::int32_t slot);

Result<Polyhedra> make_polyhedra(const Plain& skeleton, const Network& network,
                                 const Progress& progress = {});

/// Unit directions of the points that divide an arc into `pieces` of equal length, from its first vertex on:
/// pieces - 1 of them, written to `points`.
void divide_arc(const Polyhedra& polyhedra, const CellArc& arc, std::int32_t pieces, Vec3* points);

/// Length of an arc on the unit sphere, in (0, pi].
double arc_length(const Polyhedra& polyhedra, const CellArc& arc);

}  // namespace sinew::sqm
