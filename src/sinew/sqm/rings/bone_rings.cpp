#include "sinew/sqm/rings/bone_rings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sinew/mesh/limit.h"
#include "sinew/sqm/rings/ring_form.h"
#include "sinew/sqm/rings/ring_support.h"

namespace sinew::sqm {
namespace {

constexpr double steep = 0.45;  // sine of a cone's slope from which its round parts get rings of their own
constexpr double very_steep = 0.85;
/// A smooth surface draws the shoulder of a joint out along the tube, by a sixth of the way to the second ring (a cubic spline
/// is (before + 4 at + after) / 6). In edges of the ring: tubes that are longer than this get one more ring, so
/// that the shoulder ends there.
constexpr double long_tube = 4;
constexpr double end_of_shoulder = 1.2;
constexpr double most_rings_a_gap =
    10'000;  // however short the quads are to be: a bound of what one number can ask for

/// How far the points of a node's ring lean over its bones. Control points of a smooth surface are further
/// out than its radius, and lean over as much further; rings beside them that stood nearer would cross them.
double lean_of_control(const PathWork& w, std::int32_t i) {
    constexpr double most = 4;  // radii
    if (!w.options.support) return w.lean(i);
    return ring_fit_radius(w.sides) / ring_limit_radius(w.sides) * w.lean(i, most);
}

/// Part of a bone that is free for rings, as heights above its first node.
std::pair<double, double> free_part(const PathWork& w, std::int32_t bone, const ConeFrom& cone) {
    const auto end = [&](std::int32_t i, const JointSide& side, bool last) {
        if (!w.closed && (last ? i == w.count() - 1 : i == 0)) {
            if (side.any()) return side.reach;
            return last ? cone.length - cone.side_end() : cone.side_begin();
        }
        return w.kept[i % w.count()] ? std::min(lean_of_control(w, i), 0.5 * cone.length) : cone.length;
    };
    return {end(bone, w.near, false), cone.length - end(bone + 1, w.far, true)};
}

/// Whether a bone begins, at this node, at a joint's own ring or at the place where a body lets it out.
bool leaves_joint(const PathWork& w, std::int32_t i, bool at_near) {
    if (w.form(i) && w.form(i)->kind == Form::Kind::box) return false;  // a beam that goes on flush
    if (!w.closed && (at_near ? i == 0 && w.near.any() : i == w.count() - 1 && w.far.any())) return true;
    if (!w.is_fixed(i) || w.form(i)->section != Section::round) return false;
    const std::int32_t beyond = at_near ? i - 1 : i;  // the bone on the other side of the node
    return w.is_inner(i) && w.kind((beyond + w.bone_count()) % w.bone_count()) != BoneKind::tube;
}

/// Two rings beside one that the smooth surface bends at: from the second on it is as without the bend.
void offer_support(PathWork& w, double from, double sign, double edge, double room) {
    if (room > 0.9 * edge) {
        w.heights.push_back(from + sign * 0.3 * edge);
        w.heights.push_back(from + sign * 0.65 * edge);
    } else if (room > 0.3 * edge) {
        w.heights.push_back(from + sign * 0.5 * room);
    }
}

bool shaped_joint(const PathWork& w, std::int32_t i) {
    const Form* f = w.form(i);
    return f && f->kind == Form::Kind::blend &&
           (f->section == Section::rectangular || f->half.x() != f->half.y());
}

void offer_steep(PathWork& w, std::int32_t bone, const ConeFrom& cone, double low, double high) {
    const auto offer = [&](double height) {
        const double gap = 0.3 * w.edge_of(cone.radius_at(height));
        if (height < low + gap || height > high - gap) return;
        for (const double h : w.heights)
            if (std::abs(h - height) < gap) return;
        w.heights.push_back(height);
    };
    if (std::abs(cone.sine) <= steep) return;
    const double half_slope = cone.sine / std::sqrt(2 * (1 + cone.cosine));  // sine of half the angle
    const bool from_leaf = !w.closed && bone == 0 && !w.near.any();
    const bool to_leaf = !w.closed && bone + 1 == w.bone_count() && !w.far.any();
    if (cone.sine > steep && !from_leaf) offer(cone.side_begin());
    if (cone.sine > very_steep) offer(cone.near * half_slope);
    if (cone.sine < -steep && !to_leaf) offer(cone.side_end());
    if (cone.sine < -very_steep) offer(cone.length + cone.far * half_slope);
}

/// Rings between those that are there, evenly, where quads would be longer than is asked for.
void fill_gaps(PathWork& w, const ConeFrom& cone, double low, double high) {
    const auto longest = [&](double from, double to) {
        double length = std::numeric_limits<double>::infinity();
        if (w.options.aspect > 0)
            length = w.options.aspect * w.edge_of(std::min(cone.radius_at(from), cone.radius_at(to)));
        if (w.options.edge_length > 0) length = std::min(length, w.options.edge_length);
        return length;
    };
    const std::size_t stops = w.heights.size();
    double from = low;
    for (std::size_t i = 0; i <= stops; ++i) {
        const double to = i < stops ? w.heights[i] : high, gap = to - from, most = longest(from, to);
        const double pieces = std::ceil(gap / std::max(most, gap / most_rings_a_gap));
        for (int k = 1; k < pieces; ++k) w.heights.push_back(from + k / pieces * gap);
        from = to;
    }
    std::sort(w.heights.begin(), w.heights.end());
}

}  // namespace

void add_bone_rings(PathWork& w, std::int32_t bone) {
    const ConeFrom cone(w.position(bone), w.radius(bone), w.position(bone + 1), w.radius(bone + 1));
    if (cone.nested()) return;
    const std::pair<double, double> free = free_part(w, bone, cone);
    const double low = free.first, high = free.second;  // clang 14: a lambda takes no structured binding
    const bool hold_near = wants_support(w, bone), hold_far = wants_support(w, bone + 1);
    const bool at_near = !hold_near && leaves_joint(w, bone, true),
               at_far = !hold_far && leaves_joint(w, bone + 1, false);
    const double low_edge = w.edge_of(cone.radius_at(low)), high_edge = w.edge_of(cone.radius_at(high)),
                 room = high - low;
    w.heights.clear();
    if (at_near && at_far && room <= 0.75 * (low_edge + high_edge)) {
        if (room > 0.4 * (low_edge + high_edge)) w.heights.push_back((low + high) / 2);
    } else {
        const double part = hold_near || hold_far ? room / 2 : room;
        if (at_near && part > 1.25 * low_edge) w.heights.push_back(low + 0.4 * low_edge);
        if (at_far && part > 1.25 * high_edge) w.heights.push_back(high - 0.4 * high_edge);
        if (w.options.support && part > long_tube * std::max(low_edge, high_edge)) {
            if (at_near) w.heights.push_back(low + end_of_shoulder * low_edge);
            if (at_far) w.heights.push_back(high - end_of_shoulder * high_edge);
        }
    }
    const double part = hold_near && hold_far ? room / 2 : at_near || at_far ? 0.6 * room : room;
    if (hold_near) offer_support(w, low, 1, low_edge, part);
    if (hold_far) offer_support(w, high, -1, high_edge, part);
    const bool shaped =
        w.is_shaped(bone) || w.is_shaped(bone + 1) || shaped_joint(w, bone) || shaped_joint(w, bone + 1);
    if (!shaped) offer_steep(w, bone, cone, low, high);
    if (w.heights.size() > 1) std::sort(w.heights.begin(), w.heights.end());
    if (w.options.aspect > 0 || w.options.edge_length > 0) fill_gaps(w, cone, low, high);
    for (const double height : w.heights) {
        Station& ring = add_ring(w, w.position(bone) + height * cone.axis, w.way(bone),
                                 cone.radius_at(height), bone, height / cone.length);
        if (hold_near || hold_far) ring.fit = RingFit::held;
        if (!shaped) continue;
        const double share = height / cone.length;
        blend_forms(w, bone, share, ring);
        // On the round cones, as the ball of a round end beside it is, not on the lines from node to node.
        if (hold_near || hold_far)
            ring.half *= cone.radius_at(height) / ((1 - share) * w.radius(bone) + share * w.radius(bone + 1));
    }
}

}  // namespace sinew::sqm
