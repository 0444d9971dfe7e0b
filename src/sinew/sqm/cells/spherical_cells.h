/// @file spherical_cells.h
/// Directions on the unit sphere and the cells in which each of them is the nearest one.
///
/// The cells are those of the spherical Voronoi diagram, the dual of the spherical Delaunay triangulation,
/// which is the convex hull of the directions. Its vertices are the outward unit normals of the hull's faces;
/// so directions that all lie in one half-space, or in a plane (two opposite faces), need no case of their
/// own. The hull's predicate is exact: directions are rounded to a grid of 2^18 steps, where a determinant
/// fits 64 bits. K. Q. Brown, "Voronoi diagrams from convex hulls", Information Processing Letters 9(5),
/// 1979.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sinew/base/vec.h"
#include "sinew/sqm/cells/sphere_hull.h"

namespace sinew::sqm {

/// The arc between two neighbouring cells, from one vertex to another, with `left` to the left seen from
/// outside.
struct CellArc {
    std::int32_t from = 0, to = 0;
    std::int32_t left = 0, right = 0;  ///< cells
};

/// A side of a cell: one of its arcs, taken counter-clockwise round the cell seen from outside.
struct CellSide {
    std::int32_t arc = 0;
    bool reversed = false;  ///< the cell is to the right of the arc
};

/// The diagram, and its working memory: reuse one object for many joints.
struct SphericalCells {
    std::vector<Vec3> sites;  ///< unit: the directions, kept a least angle apart, then those of added cells
    std::int32_t added = 0;   ///< how many cells at the end were added to part vertices of too many sides
    std::vector<Vec3> vertices;  ///< unit
    std::vector<CellArc> arcs;
    std::vector<std::int32_t> side_first;  ///< cell -> first side; cells + 1 entries
    std::vector<CellSide> sides;

    SphereHull hull;
    std::vector<std::int32_t> arc_of, any_face;  ///< by pair of cells, by cell

    std::int32_t cell_count() const { return static_cast<std::int32_t>(sites.size()); }
    std::span<const CellSide> cell(std::int32_t c) const {
        return {sides.data() + side_first[c], sides.data() + side_first[c + 1]};
    }
};

/// @param directions  at least three unit vectors, in any position, equal ones included
///
/// Vertices closer together than a small angle are merged (cocircular directions); one where more than six
/// cells would meet gets a cell of its own in its middle. Every cell has at least two sides. Directions that
/// are nearly equal are first pushed apart. No step depends on chance or on the order of the directions, but
/// for equal ones.
void find_spherical_cells(std::span<const Vec3> directions, SphericalCells& cells);

}  // namespace sinew::sqm
