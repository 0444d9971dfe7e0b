/// @file leeway.h
/// How far the control points of a smooth surface may go, so that the control mesh stays fair.
///
/// A smooth surface lacks width that its control points have to make up for. Given all that they ask for, points at bends
/// get a nub, rings that stand close cross each other, and faces turn over. So each point has a place where it starts,
/// which is what a straight tube would ask for, and a way that it may go from there; and what still folds a face
/// goes back.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "sinew/sqm/bridge/bridge.h"

namespace sinew::sqm {

/// Where a point starts, and how far from there it may go.
struct Leeway {
    Vec3 start = Vec3::Zero(), ray = Vec3::Zero();         ///< the ray is unit, or 0: no limit along it
    double out = 0, in = 0;                                ///< along the ray and against it
    double far = std::numeric_limits<double>::infinity();  ///< and in all directions
};

/// The nearest place to a point that the leeway has.
Vec3 within(const Leeway& leeway, const Vec3& point);

/// Of a point of a ring round a tube: outwards to where the outsides of both arms of a bend meet.
/// @param target  where the smooth surface is to be
Leeway leeway_of_ring(const Plain& skeleton, const Station& ring, std::int32_t sides, const Vec3& target);

/// Which points go back together: those of a ring, and all others by themselves.
struct PointGroups {
    std::vector<std::int32_t> of;  ///< vertex -> its group; that of a ring's is its station
    std::int32_t rings = 0;        ///< so many groups are rings; the others come after
    std::int32_t count = 0;
};
PointGroups group_points(const Parts& parts, const Bridge& bridge);

/// Limits each point to a share of its shortest edge, points of rings to one of their shortest edge along the tube.
/// @param limited  by vertex: whether it is
void limit_by_edges(const QuadMesh& mesh, const PointGroups& groups, std::span<const char> limited,
                    std::span<Leeway> leeway);

/// Takes groups that fold a face which was not folded before, bit by bit, back towards where they started; at last all
/// the way. A bounded number of passes over the faces.
/// @param mesh     its positions are those before the fit
/// @param moving   the vertices that may have moved
/// @param control  by vertex, in and out
void unfold(const QuadMesh& mesh, const PointGroups& groups, std::span<const Leeway> leeway,
            std::span<const std::uint32_t> moving, std::span<Vec3> control);

}  // namespace sinew::sqm
