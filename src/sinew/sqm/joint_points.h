/// @file joint_points.h
/// The vertices of the mesh at the joints: where cells meet, and along the arcs between them.
///
/// Each lies on the joint's surface, in its own direction from the joint's centre, so a joint never folds
/// over itself. The surface is that of the round cones of its bones, or of the ball or box that the joint is,
/// less its pits.
#pragma once

#include <cstdint>
#include <vector>

#include "sinew/base/round_cone.h"
#include "sinew/sqm/refine.h"

namespace sinew::sqm {

/// A bone of scaled or rectangular section, from a joint: a frustum whose outline goes from one half extent
/// to another.
struct BeamFrom {
    Vec3 x, y, z;  ///< z along the bone
    double length = 0;
    Vec2 near, far;  ///< half extents along x and y
    Section section = Section::round;

    /// Where a ray from the middle of the near end leaves the beam; behind it, the outline turned into a cap.
    double exit(const Vec3& ray) const;
};

/// A dent: an ellipsoid whose middle lies on the surface.
struct PitShape {
    Vec3 middle, x, y, z;  ///< z outward
    Vec3 half;             ///< half width, half height, depth

    /// A vector where the ellipsoid is the unit ball.
    Vec3 local(const Vec3& v) const {
        return {v.dot(x) / half.x(), v.dot(y) / half.y(), v.dot(z) / half.z()};
    }
    /// Where a ray from the centre of the joint enters the ellipsoid, if it is inside at `distance`.
    double press(const Vec3& centre, const Vec3& ray, double distance) const;
};

/// What a slot adds to its joint's surface.
enum class SlotKind : std::uint8_t { cone, beam, surface, pit };

struct JointPoints {
    std::vector<std::uint32_t> first;      ///< joint -> its first point; joints + 1 entries
    std::vector<std::uint32_t> arc_first;  ///< arc -> the first of its pieces - 1 inner points
    std::vector<Vec3> position;  ///< joint by joint: its vertices in order, then the inner points arc by arc

    // By slot (Network::slot_first).
    std::vector<ConeFrom> cone;  ///< the round cone of the slot's first bone, from the joint
    std::vector<SlotKind> kind;
    std::vector<double> limit;          ///< how far along its bone the joint may reach
    std::vector<std::uint8_t> crowded;  ///< its bone leads straight to a joint, too short for what both want
    std::vector<std::int32_t> extra;    ///< index in beams or pits, by kind
    std::vector<BeamFrom> beams;
    /// Joint by joint: its dents, and more along the grooves that they make where they overlap.
    std::vector<PitShape> pits;
    std::vector<std::int32_t> pit_first;     ///< joint -> its first; joints + 1 entries, none without pits
    std::vector<std::int32_t> groove_first;  ///< joint -> the first of those more; none without pits
    std::vector<const Form*> body;           ///< joint -> its ball or box; null: round cones
    std::vector<std::uint8_t> only_cones;    ///< joint -> it has no body, and all its slots add cones
};

JointPoints make_joint_points(const Plain& skeleton, const Network& network, const Polyhedra& polyhedra,
                              const Refinement& refinement);

/// The node beyond a slot's first bone.
std::int32_t next_node(const Network& network, std::int32_t slot);

/// Where the ray from a joint's centre leaves its surface: the distance.
double exit_of_joint(const Network& network, const JointPoints& points, std::int32_t joint,
                     const Vec3& centre, const Vec3& ray);
/// The same, but no further along any bone than the joint may reach.
double reach_of_joint(const Network& network, const JointPoints& points, std::int32_t joint,
                      const Vec3& centre, const Vec3& ray);
/// The exit before any dent was pressed into it.
double exit_without_dents(const Network& network, const JointPoints& points, std::int32_t joint,
                          const Vec3& ray);

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
