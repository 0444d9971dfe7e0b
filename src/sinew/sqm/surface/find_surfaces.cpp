#include "sinew/sqm/surface/find_surfaces.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sinew/extend/frames.h"
#include "sinew/sqm/cells/near_directions.h"
#include "sinew/sqm/surface/dents.h"

namespace sinew::sqm {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();
/// How much of the bone between two joints they may take together: the rest keeps their points apart, so that
/// no face between them is squeezed to nothing.
constexpr double shared_length = 0.9;
/// Cosine of the angle, 0.8 degrees, below which a bone counts as lying in another one's direction.
constexpr double same_direction = 0.9999;
/// How far before a node where the path goes on a joint ends, of the radius there: its points stay clear of
/// the plane of that node's ring and of the bone that turns away from it.
constexpr double before_next_ring = 0.3;
/// How far over the centre of a leaf, of its radius, a joint may go: at the whole radius is the pole.
constexpr double before_pole = 0.9;

bool is_bone_between_joints(const Network& n, std::int32_t path) {
    return n.nodes(path).size() == 2 && n.path_end[path][0].at_joint() && n.path_end[path][1].at_joint();
}

/// The greatest cosine between a bone and another one of its joint.
double nearest_cosine(const Network& n, const JointSurfaces& surfaces, std::int32_t joint,
                      std::int32_t slot) {
    if (const CrowdedSlots* crowd = surfaces.crowd(joint))
        return crowd->nearest_cosine(surfaces.cones(n, joint), slot - n.slot_first[joint]);
    double nearest = -1;
    for (std::int32_t other = n.slot_first[joint]; other < n.slot_first[joint + 1]; ++other)
        if (other != slot)
            nearest = std::max(nearest, surfaces.cone[slot].axis.dot(surfaces.cone[other].axis));
    return nearest;
}

/// How far along its bone a joint would like to reach: to where the tube leaves the nearest of its
/// neighbours, at half the angle between both.
double wanted_reach(const Network& n, const JointSurfaces& surfaces, std::int32_t joint, std::int32_t slot) {
    const ConeFrom& cone = surfaces.cone[slot];
    const double nearest = nearest_cosine(n, surfaces, joint, slot);
    const double tangent = std::sqrt((1 - std::min(1.0, nearest)) / (1 + nearest + 1e-12));
    const double closing = cone.cosine * tangent + cone.sine;
    const double reach = closing > 0 ? cone.near / closing : cone.length;
    return std::clamp(reach, std::min(cone.near, cone.length), cone.length);
}

/// Two joints share the bone between them by what each would like; what is left over by their radii.
void share_bone(const Network& n, std::int32_t path, JointSurfaces& surfaces) {
    const auto& ends = n.path_end[path];
    const std::int32_t a = n.slot_first[ends[0].joint] + ends[0].slot,
                       b = n.slot_first[ends[1].joint] + ends[1].slot;
    const double wanted_a = wanted_reach(n, surfaces, ends[0].joint, a),
                 wanted_b = wanted_reach(n, surfaces, ends[1].joint, b);
    const ConeFrom& cone = surfaces.cone[a];
    const double whole = shared_length * cone.length, spare = whole - wanted_a - wanted_b;
    if (spare >= 0) {
        surfaces.limit[a] = wanted_a + spare * cone.near / (cone.near + cone.far);
        surfaces.limit[b] = wanted_b + spare * cone.far / (cone.near + cone.far);
    } else {
        surfaces.limit[a] = whole * wanted_a / (wanted_a + wanted_b);
        surfaces.limit[b] = whole * wanted_b / (wanted_a + wanted_b);
        surfaces.crowded[a] = surfaces.crowded[b] = 1;
    }
}

/// Whether another bone leaves a joint in the very direction of this one.
bool is_along_another(const Network& n, const JointSurfaces& surfaces, std::int32_t joint,
                      std::int32_t slot) {
    return nearest_cosine(n, surfaces, joint, slot) > same_direction;
}

/// Where the bones of a narrow fork part beyond the next node, the joint ends before that node: further, it
/// would be in the way of the ring there and of the bone that turns away from it. It may go over a leaf, but
/// not to the pole of one that is inside another bone.
void end_at_next_node(const Network& n, std::int32_t path, JointSurfaces& surfaces) {
    for (const PathEnd& end : n.path_end[path]) {
        if (!end.at_joint() || surfaces.body[end.joint]) continue;
        const std::int32_t slot = n.slot_first[end.joint] + end.slot;
        const ConeFrom& cone = surfaces.cone[slot];
        const bool leaf = n.nodes(path).size() == 2;
        const bool tube = surfaces.kind[slot] == SlotKind::cone || surfaces.kind[slot] == SlotKind::beam;
        if (!tube || (leaf && !is_along_another(n, surfaces, end.joint, slot))) continue;
        const double most = cone.length + (leaf ? before_pole : -before_next_ring) * cone.far;
        if (most > cone.near) surfaces.limit[slot] = most;
    }
}

SlotKind kind_of(const Plain& s, const Network& n, std::int32_t node, std::int32_t slot) {
    const std::int32_t next = n.next_node(slot);
    if (n.nodes(n.slot_path[slot].path).size() == 2) {
        if (s.cap[next] == Cap::surface) return SlotKind::surface;
        if (s.cap[next] == Cap::pit) return SlotKind::pit;
    }
    const auto shaped = [&](std::int32_t i) {
        const Form* f = s.form(i);
        return f && f->kind != Form::Kind::ball &&
               (f->section == Section::rectangular || f->half.x() != f->half.y());
    };
    return shaped(node) || (shaped(next) && !s.is_body(next)) ? SlotKind::beam : SlotKind::cone;
}

/// The joints whose bones are too many to go through for every ray.
void find_crowds(const Network& n, JointSurfaces& surfaces) {
    for (std::int32_t j = 0; j < n.joint_count(); ++j) {
        if (n.degree(j) <= crowd) continue;
        surfaces.crowd_of.resize(n.joint_count(), -1);
        surfaces.crowd_of[j] = static_cast<std::int32_t>(surfaces.crowds.size());
        surfaces.crowds.emplace_back(surfaces.cones(n, j));
    }
}

BeamFrom beam_of(const Plain& s, std::int32_t node, std::int32_t next, const ConeFrom& cone) {
    const Form *at = s.form(node), *beyond = s.form(next);
    const auto outline = [&](const Form* f, double radius) {
        return f && f->kind != Form::Kind::ball ? Vec2(f->half.x(), f->half.y()) : Vec2(radius, radius);
    };
    const Form* leads = beyond && !s.is_body(next) ? beyond : at;  // whose outline and turn the beam has
    const Vec3 z = leads->z.dot(cone.axis) < -1e-9 ? Vec3(-leads->z) : leads->z;
    const Frame frame = turn_frame({leads->x, z.cross(leads->x), z}, cone.axis);
    BeamFrom beam{frame.x,
                  frame.y,
                  frame.z,
                  cone.length,
                  outline(at, s.radius[node]),
                  outline(beyond, s.radius[next]),
                  leads->section};
    if (at && leads != at && std::abs(at->x.dot(frame.y)) > std::abs(at->x.dot(frame.x)))
        std::swap(beam.near.x(), beam.near.y());
    return beam;
}

}  // namespace

JointSurfaces find_surfaces(const Plain& s, const Network& n) {
    JointSurfaces surfaces;
    const std::size_t slots = n.slot_path.size();
    surfaces.cone.resize(slots);
    surfaces.kind.resize(slots, SlotKind::cone);
    surfaces.limit.resize(slots, no_limit);
    surfaces.crowded.resize(slots, 0);
    surfaces.extra.resize(slots, -1);
    surfaces.body.resize(n.joint_count());
    surfaces.only_cones.assign(n.joint_count(), 1);
    if (!s.blend.empty())
        for (const std::int32_t node : n.joint_node)
            surfaces.rolling.push_back(s.blend[node] * s.radius[node]);
    tbb::parallel_for(tbb::blocked_range<std::int32_t>(0, n.joint_count(), 64), [&](const auto& range) {
        for (std::int32_t j = range.begin(); j < range.end(); ++j) {
            const std::int32_t node = n.joint_node[j];
            surfaces.body[j] = s.form(node);
            for (std::int32_t slot = n.slot_first[j]; slot < n.slot_first[j + 1]; ++slot) {
                const std::int32_t next = n.next_node(slot);
                surfaces.cone[slot] = {s.position[node], s.radius[node], s.position[next], s.radius[next]};
                if (!s.forms.empty()) surfaces.kind[slot] = kind_of(s, n, node, slot);
                if (surfaces.body[j] || surfaces.kind[slot] != SlotKind::cone) surfaces.only_cones[j] = 0;
            }
        }
    });
    find_crowds(n, surfaces);
    tbb::parallel_for(tbb::blocked_range<std::int32_t>(0, n.path_count(), 128), [&](const auto& range) {
        for (std::int32_t p = range.begin(); p < range.end(); ++p)
            is_bone_between_joints(n, p) ? share_bone(n, p, surfaces) : end_at_next_node(n, p, surfaces);
    });
    for (std::int32_t j = 0; j < std::ssize(surfaces.crowd_of); ++j)
        if (surfaces.crowd_of[j] >= 0)
            surfaces.crowds[surfaces.crowd_of[j]].set_limits(surfaces.limits(n, j));
    if (s.forms.empty()) return surfaces;
    for (std::int32_t j = 0; j < n.joint_count(); ++j) {
        const std::int32_t node = n.joint_node[j];
        for (std::int32_t slot = n.slot_first[j]; slot < n.slot_first[j + 1]; ++slot)
            if (surfaces.kind[slot] == SlotKind::beam) {
                surfaces.extra[slot] = static_cast<std::int32_t>(surfaces.beams.size());
                surfaces.beams.push_back(beam_of(s, node, n.next_node(slot), surfaces.cone[slot]));
            }
    }
    if (std::find(surfaces.kind.begin(), surfaces.kind.end(), SlotKind::pit) != surfaces.kind.end())
        find_dents(s, n, surfaces);
    return surfaces;
}

}  // namespace sinew::sqm
