#include "sinew/sqm/surface/cell_room.h"

#include <algorithm>
#include <limits>

namespace sinew::sqm {
namespace {

/// What is left free between a wall and a place that is pulled in, of the distance between the wall and the
/// middle of the cell. Two tubes that touch a wall from both sides are then a
/// twentieth of the way apart from the middle of the one cell to that of the other.
constexpr double margin = 0.05;
/// How far along a ray to a wall one may go, of the distance to it: what is there lies inside, however it is
/// rounded to single precision.
constexpr double nearly_to_wall = 0.98;
/// Sine of the least angle, 1.1 degrees, between a bone and a wall of its cell for which the bone may stand
/// for the cell's middle: walls are measured in units of it.
constexpr double least_clearance = 0.02;

}  // namespace

CellRoom::CellRoom(const Plain& s, const Network& n, const Polyhedra& p, const JointSurfaces& surfaces,
                   std::int32_t joint, std::int32_t slot)
    : centre_(s.position[n.joint_node[joint]]), middle_(surfaces.cone[n.slot_first[joint] + slot].axis) {
    const std::int32_t first_cell = p.cell_first[joint], cell = first_cell + slot;
    for (const CellSide& side : p.cell(cell)) {
        const CellArc& arc = p.arcs[side.arc];
        const std::int32_t beside = (arc.left == cell ? arc.right : arc.left) - first_cell;
        const bool is_bone = beside < n.degree(joint);
        const ConeFrom& cone = surfaces.cone[n.slot_first[joint] + (is_bone ? beside : slot)];
        const double until = is_bone ? cone.length + cone.far : std::numeric_limits<double>::infinity();
        Vec3 middle;  // arcs may be half circles
        divide_arc(p, arc, 2, &middle);
        for (const auto& [from, to] :
             {std::pair(p.vertices[arc.from], middle), std::pair(middle, p.vertices[arc.to])})
            walls_.push_back({arc.left == cell ? from.cross(to) : to.cross(from), until});
    }
    // Directions that nearly coincide are drawn apart, and then a bone may be outside its cell.
    if (std::any_of(walls_.begin(), walls_.end(), [&](const Wall& wall) {
            return wall.inward.dot(middle_) < least_clearance * wall.inward.norm();
        }))
        middle_ = p.sites[cell];
    for (Wall& wall : walls_) wall.inward /= wall.inward.dot(middle_);
}

Vec3 CellRoom::pull_in(const Vec3& place) const {
    const Vec3 from = place - centre_;
    const double distance = from.norm(), height = from.dot(middle_) > 0 ? from.dot(middle_) : distance;
    double share = 0;
    for (const Wall& wall : walls_) {
        const double at = wall.inward.dot(from) / height;  // 1 in the middle, 0 on the wall
        if (distance < wall.until && at < margin) share = std::max(share, (margin - at) / (1 - at));
    }
    return share > 0 ? Vec3(place + share * (height * middle_ - from)) : place;
}

double CellRoom::free_distance(const Vec3& place, const Vec3& ray, double most) const {
    const Vec3 from = place - centre_;
    const double nearest = from.norm() - most;
    double way = most;
    for (const Wall& wall : walls_) {
        const double room = wall.inward.dot(from), closing = -wall.inward.dot(ray);
        if (nearest < wall.until && room > 0 && closing > 0)
            way = std::min(way, nearly_to_wall * room / closing);
    }
    return way;
}

}  // namespace sinew::sqm
