#include "sinew/sqm/stations.h"

#include <algorithm>

#include "sinew/base/portable_math.h"
#include "sinew/sqm/chunks.h"
#include "sinew/sqm/follow_rings.h"
#include "sinew/sqm/path_angles.h"
#include "sinew/sqm/path_rings.h"

namespace sinew::sqm {
namespace {

constexpr std::int32_t paths_a_task = 256;  // paths that one task takes

/// Cosine of the angle between a unit vector and the arc between two others' directions, if the nearest point
/// is not one of its ends; else -1.
double cosine_to_inside(const Vec3& axis, const Vec3& from, const Vec3& to) {
    const double aa = from.squaredNorm(), bb = to.squaredNorm(), ab = from.dot(to);
    const double a = from.dot(axis), b = to.dot(axis);
    if (!(b * aa > a * ab && a * bb > b * ab)) return -1;
    const double square = (a * a * bb + b * b * aa - 2 * ab * a * b) / (aa * bb - ab * ab);
    return std::sqrt(std::clamp(square, 0.0, 1.0));  // length of what the axis throws on the plane of the arc
}

/// Tangent of the least angle between the bone and the border of its cell; 0 if that is a right angle or
/// more.
double room_in_cell(const JointSide& side, const Vec3& axis) {
    double cosine = side.narrowest;
    const Vec3* before = &side.points.back();
    for (const Vec3& point : side.points) {
        cosine = std::max(cosine, cosine_to_inside(axis, *before, point));
        before = &point;
    }
    return cosine > 0 ? std::sqrt(std::max(0.0, 1 - cosine * cosine)) / cosine : 0;
}

/// How far along its bone the side of a cone needs to be inside the directions of its cell, so that it cannot
/// run into the neighbours' tubes. Not further than the joint may reach; 0 where that is not enough.
double height_in_cell(const JointSide& side, const ConeFrom& cone, double limit) {
    if (side.room <= 0 || cone.nested()) return 0;
    const double closing = cone.cosine * side.room + cone.sine;
    const double height = closing > 0 ? cone.near / closing : limit;
    return height < limit ? height : 0;
}

/// Whether a ring on the bone that leaves a joint is too wide for the joint's cell, from its centre.
bool is_crowded(const JointSide& side, const Station& ring) {
    constexpr double tight = 0.95;
    const double across = ring.half.maxCoeff();
    double height = (ring.centre - side.centre).dot(side.axis);
    if (ring.shape == RingShape::node) {  // leans over the bone
        const double cosine = std::abs(ring.tangent.dot(side.axis));
        height -= across * std::sqrt(std::max(0.0, 1 - cosine * cosine)) / std::max(0.2, cosine);
    }
    return across > tight * side.room * height;
}

void take_joint(PathWork& w, JointSide& side, const PathEnd& end, bool is_far) {
    side.ring.clear();
    side.points.clear();
    side.joint = end.joint;
    side.reach = side.farthest = 0;
    side.widest = 1;
    side.narrowest = -1;
    side.room = 0;
    if (!end.at_joint()) return;
    side.cell = w.p.cell_first[end.joint] + end.slot;
    append_ring(w.p, w.r, w.points, end.joint, side.cell, side.ring);
    if (is_far) std::reverse(side.ring.begin(), side.ring.end());
    side.centre = w.s.position[w.n.joint_node[end.joint]];
    const std::int32_t slot = w.n.slot_first[end.joint] + end.slot;
    const ConeFrom& cone = w.points.cone[slot];
    side.axis = cone.axis;
    for (const std::uint32_t i : side.ring) {
        const Vec3& point = side.points.emplace_back(w.points.position[i] - side.centre);
        const double distance = point.norm(), along = point.dot(cone.axis), cosine = along / distance;
        side.reach = std::max(side.reach, along);
        side.farthest = std::max(side.farthest, distance);
        side.widest = std::min(side.widest, cosine);
        side.narrowest = std::max(side.narrowest, cosine);
    }
    if (w.points.body[end.joint] || w.points.kind[slot] != SlotKind::cone) return;
    side.room = room_in_cell(side, cone.axis);
    const double limit = std::min(cone.length - 0.25 * cone.far, w.points.limit[slot]);
    side.reach = std::max(side.reach, height_in_cell(side, cone, limit));
}

void find_crowded(const PathWork& w) {
    std::array<std::uint8_t, 2> crowded{};
    for (int end = 0; end < 2; ++end) {
        const JointSide& side = end == 0 ? w.near : w.far;
        if (side.room <= 0) continue;
        const std::int32_t bone = end == 0 ? 0 : w.bone_count() - 1, node = w.node(end == 0 ? 1 : bone);
        for (const Station& ring : w.rings)
            if (may_be_pulled(ring, w.bones[bone], node)) crowded[end] |= is_crowded(side, ring);
    }
    w.out.crowded.push_back(crowded);
}

/// @param least_rings  rings that the path must have, so that no two paths share an edge
void build(PathWork& w, std::int32_t path, std::int32_t least_rings) {
    w.path = path;
    w.nodes = w.n.nodes(path);
    w.bones = w.n.bones(path);
    w.closed = w.n.path_closed[path];
    if (const std::int32_t sides = w.r.path_sides[path]; sides != w.sides) {
        w.sides = sides;
        w.edge = 2 * portable::sine_cosine(M_PI / sides).sine;
        w.step = portable::sine_cosine(2 * M_PI / sides);
    }
    take_joint(w, w.near, w.n.path_end[path][0], false);
    take_joint(w, w.far, w.n.path_end[path][1], true);
    place_rings(w, false);
    if (std::ssize(w.rings) < least_rings) place_rings(w, true);
    find_crowded(w);
    find_angles(w);
    add_follow_rings(w);
    w.out.stations.insert(w.out.stations.end(), w.rings.begin(), w.rings.end());
    w.out.first.push_back(static_cast<std::int32_t>(w.out.stations.size()));
    w.out.angle_first.push_back(static_cast<std::int32_t>(w.out.angle.size()));
}

/// Rings that each path must have: two on a path from a joint to itself, one on each of several between the
/// same two joints that has nodes to carry it; all others may do with none.
std::vector<std::uint8_t> least_rings(const Network& n) {
    std::vector<std::uint8_t> least(n.path_count(), 0);
    std::vector<std::array<std::int32_t, 3>> pairs;
    for (std::int32_t p = 0; p < n.path_count(); ++p) {
        const auto [a, b] = std::minmax(n.path_end[p][0].joint, n.path_end[p][1].joint);
        if (a == b && a >= 0) least[p] = 2;
        if (a != b && a >= 0) pairs.push_back({a, b, p});
    }
    std::sort(pairs.begin(), pairs.end());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto same = [&](std::size_t j) {
            return j < pairs.size() && pairs[j][0] == pairs[i][0] && pairs[j][1] == pairs[i][1];
        };
        const std::int32_t path = pairs[i][2];
        if (n.nodes(path).size() > 2 && (same(i + 1) || (i > 0 && same(i - 1)))) least[path] = 1;
    }
    return least;
}

void clear(Stations& s) {
    s.stations.clear(), s.angle.clear(), s.near_uneven.clear(), s.far_uneven.clear();
    s.far_shift.clear(), s.corner.clear(), s.crowded.clear();
    s.first = s.angle_first = {0};
}

/// Room for all rings, judged by those of the first part.
void reserve(Stations& all, const Stations& part, const Network& n, const Refinement& r) {
    std::size_t columns = 0;
    for (const std::int32_t sides : r.path_sides) columns += sides;
    const double paths = n.path_count(), share = static_cast<double>(part.far_shift.size()) / paths;
    all.stations.reserve(static_cast<std::size_t>(1.1 * part.stations.size() / share) + 64);
    for (std::vector<double>* array : {&all.angle, &all.near_uneven, &all.far_uneven})
        array->reserve(columns);
    for (std::vector<std::int32_t>* array : {&all.first, &all.angle_first, &all.far_shift, &all.corner})
        array->reserve(n.path_count() + 1);
    all.crowded.reserve(n.path_count());
}

void append_part(Stations& to, const Stations& from) {
    const std::int32_t ring = to.first.back(), angle = to.angle_first.back();
    for (std::size_t i = 1; i < from.first.size(); ++i) {
        to.first.push_back(from.first[i] + ring);
        to.angle_first.push_back(from.angle_first[i] + angle);
    }
    const auto append = [](auto& a, const auto& b) { a.insert(a.end(), b.begin(), b.end()); };
    append(to.stations, from.stations);
    append(to.angle, from.angle);
    append(to.near_uneven, from.near_uneven);
    append(to.far_uneven, from.far_uneven);
    append(to.far_shift, from.far_shift);
    append(to.corner, from.corner);
    append(to.crowded, from.crowded);
}

}  // namespace

Stations make_stations(const Plain& skeleton, const Network& network, const Polyhedra& polyhedra,
                       const Refinement& refinement, const JointPoints& points,
                       const StationOptions& options) {
    const std::vector<std::uint8_t> least = least_rings(network);
    Stations all;
    clear(all);
    for_chunks<Stations>(
        network.path_count(), paths_a_task,
        [&](Stations& part, std::int32_t begin, std::int32_t end) {
            clear(part);
            PathWork work{skeleton, network, polyhedra, refinement, points, options, part};
            for (std::int32_t p = begin; p < end; ++p) build(work, p, least[p]);
        },
        [&](Stations& part) {
            if (all.far_shift.empty()) reserve(all, part, network, refinement);
            append_part(all, part);
        });
    return all;
}

}  // namespace sinew::sqm
