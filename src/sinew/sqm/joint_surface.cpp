#include "sinew/sqm/joint_surface.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sinew/extend/bodies.h"
#include "sinew/extend/frames.h"
#include "sinew/sqm/dents.h"

namespace sinew::sqm {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

bool is_bone_between_joints(const Network& n, std::int32_t path) {
    return n.nodes(path).size() == 2 && n.path_end[path][0].at_joint() && n.path_end[path][1].at_joint();
}

/// How far along its bone a joint would like to reach: to where the tube leaves the nearest of its
/// neighbours, at half the angle between both.
double wanted_reach(const Network& n, const JointPoints& points, std::int32_t joint, std::int32_t slot) {
    const ConeFrom& cone = points.cone[slot];
    double nearest = -1;  // cosine
    for (std::int32_t other = n.slot_first[joint]; other < n.slot_first[joint + 1]; ++other)
        if (other != slot) nearest = std::max(nearest, cone.axis.dot(points.cone[other].axis));
    const double tangent = std::sqrt((1 - std::min(1.0, nearest)) / (1 + nearest + 1e-12));
    const double closing = cone.cosine * tangent + cone.sine;
    const double reach = closing > 0 ? cone.near / closing : cone.length;
    return std::clamp(reach, std::min(cone.near, cone.length), cone.length);
}

/// Two joints share the bone between them by what each would like; what is left over by their radii.
void share_bone(const Network& n, std::int32_t path, JointPoints& points) {
    const auto& ends = n.path_end[path];
    const std::int32_t a = n.slot_first[ends[0].joint] + ends[0].slot,
                       b = n.slot_first[ends[1].joint] + ends[1].slot;
    const double wanted_a = wanted_reach(n, points, ends[0].joint, a),
                 wanted_b = wanted_reach(n, points, ends[1].joint, b);
    const ConeFrom& cone = points.cone[a];
    const double whole = 0.9 * cone.length, spare = whole - wanted_a - wanted_b;
    if (spare >= 0) {
        points.limit[a] = wanted_a + spare * cone.near / (cone.near + cone.far);
        points.limit[b] = wanted_b + spare * cone.far / (cone.near + cone.far);
    } else {
        points.limit[a] = whole * wanted_a / (wanted_a + wanted_b);
        points.limit[b] = whole * wanted_b / (wanted_a + wanted_b);
        points.crowded[a] = points.crowded[b] = 1;
    }
}

/// Whether another bone leaves a joint in the very direction of this one.
bool is_along_another(const Network& n, const JointPoints& points, std::int32_t joint, std::int32_t slot) {
    for (std::int32_t other = n.slot_first[joint]; other < n.slot_first[joint + 1]; ++other)
        if (other != slot && points.cone[slot].axis.dot(points.cone[other].axis) > 0.9999) return true;
    return false;
}

/// Where the bones of a narrow fork part beyond the next node, the joint ends before that node: further, it
/// would be in the way of the ring there and of the bone that turns away from it. It may go over a leaf, but
/// not to the pole of one that is inside another bone.
void end_at_next_node(const Network& n, std::int32_t path, JointPoints& points) {
    for (const PathEnd& end : n.path_end[path]) {
        if (!end.at_joint() || points.body[end.joint]) continue;
        const std::int32_t slot = n.slot_first[end.joint] + end.slot;
        const ConeFrom& cone = points.cone[slot];
        const bool leaf = n.nodes(path).size() == 2;
        const bool tube = points.kind[slot] == SlotKind::cone || points.kind[slot] == SlotKind::beam;
        if (!tube || (leaf && !is_along_another(n, points, end.joint, slot))) continue;
        const double most = cone.length + (leaf ? 0.9 : -0.3) * cone.far;
        if (most > cone.near) points.limit[slot] = most;
    }
}

SlotKind kind_of(const Plain& s, const Network& n, std::int32_t node, std::int32_t slot) {
    const std::int32_t next = next_node(n, slot);
    if (n.nodes(n.slot_path[slot] / 2).size() == 2) {
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

std::int32_t next_node(const Network& n, std::int32_t slot) {
    const std::int32_t path_and_end = n.slot_path[slot];
    const auto nodes = n.nodes(path_and_end / 2);
    return path_and_end % 2 == 0 ? nodes[1] : nodes[nodes.size() - 2];
}

double BeamFrom::exit(const Vec3& ray) const {
    const double p = std::abs(ray.dot(x)), q = std::abs(ray.dot(y)), h = ray.dot(z);
    if (h <= 0) {  // behind: a cap as deep as the outline is narrow
        const double depth = near.minCoeff();
        const Vec3 local(p / near.x(), q / near.y(), -h / depth);
        return section == Section::rectangular ? 1 / std::max({local.x(), local.y(), local.z()})
                                               : 1 / local.norm();
    }
    // The outline at height t h is near + (far - near) t h / length.
    const auto side = [&](double lateral, double from, double to) {
        const double closing = lateral - h * (to - from) / length;
        return closing > 0 ? from / closing : std::numeric_limits<double>::infinity();
    };
    const double end = length / h;
    if (section == Section::rectangular)
        return std::min({end, side(p, near.x(), far.x()), side(q, near.y(), far.y())});
    double low = 0, high = end;
    for (int i = 0; i < 40; ++i) {
        const double t = (low + high) / 2, share = t * h / length;
        const Vec2 half = near + share * (far - near);
        (Vec2(p * t / half.x(), q * t / half.y()).squaredNorm() < 1 ? low : high) = t;
    }
    return low;
}

double exit_without_dents(const Network& network, const JointPoints& points, std::int32_t joint,
                          const Vec3& ray) {
    const Form* body = points.body[joint];
    if (body && body->kind == Form::Kind::box) return exit_of_box(*body, ray);
    if (body && body->kind == Form::Kind::ball) return exit_of_ellipsoid(*body, ray);
    double distance = 0;
    for (std::int32_t slot = network.slot_first[joint]; slot < network.slot_first[joint + 1]; ++slot) {
        if (points.kind[slot] == SlotKind::cone) distance = std::max(distance, points.cone[slot].exit(ray));
        if (points.kind[slot] == SlotKind::beam)
            distance = std::max(distance, points.beams[points.extra[slot]].exit(ray));
        if (distance == 0) distance = points.cone[slot].near;  // only pits and bare surface: the ball itself
    }
    return distance;
}

double exit_of_joint(const Network& network, const JointPoints& points, std::int32_t joint,
                     const Vec3& centre, const Vec3& ray) {
    if (points.only_cones[joint]) {
        double distance = 0;
        for (std::int32_t slot = network.slot_first[joint]; slot < network.slot_first[joint + 1]; ++slot)
            distance = std::max(distance, points.cone[slot].exit(ray));
        return distance;
    }
    return press_dents(points, joint, centre, ray, exit_without_dents(network, points, joint, ray));
}

void find_joint_surfaces(const Plain& s, const Network& n, JointPoints& points) {
    const std::size_t slots = n.slot_path.size();
    points.cone.resize(slots);
    points.kind.resize(slots, SlotKind::cone);
    points.limit.resize(slots, no_limit);
    points.crowded.resize(slots, 0);
    points.extra.resize(slots, -1);
    points.body.resize(n.joint_count());
    points.only_cones.assign(n.joint_count(), 1);
    tbb::parallel_for(tbb::blocked_range<std::int32_t>(0, n.joint_count(), 64), [&](const auto& range) {
        for (std::int32_t j = range.begin(); j < range.end(); ++j) {
            const std::int32_t node = n.joint_node[j];
            points.body[j] = s.form(node);
            for (std::int32_t slot = n.slot_first[j]; slot < n.slot_first[j + 1]; ++slot) {
                const std::int32_t next = next_node(n, slot);
                points.cone[slot] = {s.position[node], s.radius[node], s.position[next], s.radius[next]};
                if (!s.forms.empty()) points.kind[slot] = kind_of(s, n, node, slot);
                if (points.body[j] || points.kind[slot] != SlotKind::cone) points.only_cones[j] = 0;
            }
        }
    });
    tbb::parallel_for(tbb::blocked_range<std::int32_t>(0, n.path_count(), 128), [&](const auto& range) {
        for (std::int32_t p = range.begin(); p < range.end(); ++p)
            is_bone_between_joints(n, p) ? share_bone(n, p, points) : end_at_next_node(n, p, points);
    });
    if (s.forms.empty()) return;
    for (std::int32_t j = 0; j < n.joint_count(); ++j) {
        const std::int32_t node = n.joint_node[j];
        for (std::int32_t slot = n.slot_first[j]; slot < n.slot_first[j + 1]; ++slot)
            if (points.kind[slot] == SlotKind::beam) {
                points.extra[slot] = static_cast<std::int32_t>(points.beams.size());
                points.beams.push_back(beam_of(s, node, next_node(n, slot), points.cone[slot]));
            }
    }
    if (std::find(points.kind.begin(), points.kind.end(), SlotKind::pit) != points.kind.end())
        find_dents(s, n, points);
}

}  // namespace sinew::sqm
