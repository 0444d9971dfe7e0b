#include "sinew/sqm/rings/joint_side.h"

#include <algorithm>
#include <cmath>

namespace sinew::sqm {
namespace {

/// A point of the joint's ring, seen from its centre.
struct Seen {
    const Vec3* point;
    double square, along;  ///< of the distance; along the bone

    Seen(const Vec3& place, const Vec3& axis)
        : point(&place), square(place.squaredNorm()), along(place.dot(axis)) {}
};

/// Squared cosine of the angle between the bone and the arc between two points' directions, if the nearest
/// point is not one of its ends; else 0.
double square_to_inside(const Seen& from, const Seen& to) {
    const double aa = from.square, bb = to.square, ab = from.point->dot(*to.point);
    const double a = from.along, b = to.along;
    if (!(b * aa > a * ab && a * bb > b * ab)) return 0;
    return (a * a * bb + b * b * aa - 2 * ab * a * b) /
           (aa * bb - ab * ab);  // of the axis in the arc's plane
}

/// How far the joint's points go, and at what angles to the bone they and the arcs between them are.
void look_along(const Vec3& axis, JointSide& side) {
    double reach = 0, farthest = 0, widest = 1, narrowest = -1, inside = 0;
    Seen before(side.points.back(), axis);
    for (const Vec3& place : side.points) {
        const Seen seen(place, axis);
        const double distance = std::sqrt(seen.square), cosine = seen.along / distance;
        reach = std::max(reach, seen.along);
        farthest = std::max(farthest, distance);
        widest = std::min(widest, cosine);
        narrowest = std::max(narrowest, cosine);
        inside = std::max(inside, square_to_inside(before, seen));
        before = seen;
    }
    side.reach = reach;
    side.farthest = farthest;
    side.widest = widest;
    const double nearest = std::max(narrowest, std::sqrt(std::min(inside, 1.0)));
    side.room = nearest > 0 ? std::sqrt(std::max(0.0, 1 - nearest * nearest)) / nearest : 0;
}

/// How far along its bone the side of a cone needs to be inside the directions of its cell, so that it cannot
/// run into the neighbours' tubes. Not further than the joint may reach; 0 where that is not enough.
double height_in_cell(const JointSide& side, const ConeFrom& cone, double limit) {
    if (side.room <= 0 || cone.nested()) return 0;
    const double closing = cone.cosine * side.room + cone.sine;
    const double height = closing > 0 ? cone.near / closing : limit;
    return height < limit ? height : 0;
}

}  // namespace

void take_joint(const PathWork& w, const PathEnd& end, bool is_far, JointSide& side) {
    side.joint = end.joint;
    side.room = 0;
    if (!end.at_joint()) return;
    side.cell = w.p.cell_first[end.joint] + end.slot;
    side.centre = w.s.position[w.n.joint_node[end.joint]];
    side.ring.resize(w.sides);
    side.points.resize(w.sides);
    std::int32_t k = is_far ? w.sides : -1;
    for_ring(w.p, w.r, w.points, end.joint, side.cell, [&](std::uint32_t point) {
        k += is_far ? -1 : 1;
        side.ring[k] = point;
        side.points[k] = w.points.position[point] - side.centre;
    });
    const std::int32_t slot = w.n.slot_first[end.joint] + end.slot;
    const ConeFrom& cone = w.surfaces.cone[slot];
    side.axis = cone.axis;
    look_along(cone.axis, side);
    if (w.surfaces.body[end.joint] || w.surfaces.kind[slot] != SlotKind::cone) {
        side.room = 0;
        return;
    }
    const double limit = std::min(cone.length - 0.25 * cone.far, w.surfaces.limit[slot]);
    side.reach = std::max(side.reach, height_in_cell(side, cone, limit));
}

}  // namespace sinew::sqm
