#include "sinew/sqm/rings/path_rings.h"

#include <algorithm>
#include <cmath>

#include "sinew/sqm/rings/bone_rings.h"
#include "sinew/sqm/rings/end_rings.h"
#include "sinew/sqm/rings/ring_form.h"
#include "sinew/sqm/rings/ring_support.h"
#include "sinew/sqm/surface/joint_reach.h"

namespace sinew::sqm {
namespace {

std::int32_t widest_bone(const PathWork& w) {
    const auto width = [&](std::int32_t b) { return w.radius(b) + w.radius(b + 1); };
    std::int32_t widest = 0;
    for (std::int32_t b = 1; b < w.bone_count(); ++b)
        if (width(b) > width(widest)) widest = b;
    return widest;
}

/// Where a path turns straight back into itself it bores a hole: its rings go on as the same tube, inwards,
/// and are not turned over.
void find_bores(PathWork& w) {
    bool inside = false, any = false;
    for (std::int32_t b = 0; b < w.bone_count(); ++b) {
        if (b > 0 && w.direction(b - 1).dot(w.direction(b)) < -0.999) inside = !inside, any = true;
        w.bored.push_back(inside);
    }
    if (!any || (w.near.any() && w.far.any() && inside)) return w.bored.clear();
    const bool outer = w.near.any() ? false : w.far.any() ? inside : w.bored[widest_bone(w)] != 0;
    for (std::uint8_t& bore : w.bored) bore = (bore != 0) != outer;
}

/// Whether a place is seen from a joint through its cell, or hardly beside it.
bool in_cell(const PathWork& w, const JointSide& side, const Vec3& place) {
    constexpr double hardly = 0.1;                 // sine
    const double turn = &side == &w.far ? -1 : 1;  // its points go clockwise
    const Vec3 to = (place - side.centre).normalized();
    const Vec3* before = &side.points.back();
    for (const Vec3& point : side.points) {
        const Vec3 wall = before->cross(point);
        if (turn * wall.dot(to) < -hardly * wall.norm()) return false;
        before = &point;
    }
    return true;
}
/// Rings inside a joint's own part are left out, but for those that were asked for, and those from which
/// the path turns into its neighbours' part.
void leave_out_nodes(PathWork& w) {
    const auto inside = [&](const JointSide& side, std::int32_t i, std::int32_t next, const Vec3& axis) {
        if (w.is_fixed(i)) return false;
        const Vec3 from = w.position(i) - side.centre;
        const double r = w.radius(i);
        if (const Form* body = w.surfaces.body[side.joint]; body && body->kind != Form::Kind::blend)
            return from.norm() < exit_of_joint(w.n, w.surfaces, side.joint, side.centre, from.normalized());
        return from.dot(axis) - w.lean(i) < side.reach + 0.1 * r && from.norm() < side.farthest + 0.1 * r &&
               in_cell(w, side, w.position(next));
    };
    const std::int32_t last = w.count() - 1;
    if (w.near.any())
        for (std::int32_t i = 1; i < last && inside(w.near, i, i + 1, w.direction(0)); ++i) w.kept[i] = 0;
    if (w.far.any())
        for (std::int32_t i = last - 1; i > 0 && inside(w.far, i, i - 1, -w.direction(last - 1)); --i)
            w.kept[i] = 0;
}

void add_at_node(PathWork& w, std::int32_t i) {
    const Vec3 in = w.way(i - 1), out = w.way(i), sum = in + out;
    Station& ring = add_ring(w, w.position(i), sum.norm() > 1e-6 ? sum.normalized() : in, w.radius(i),
                             i % w.bone_count(), 0);
    ring.node = w.node(i);
    ring.before = w.node(i - 1);
    ring.after = w.node(i + 1);
    ring.shape = RingShape::node;
    if (w.options.support && is_base_of_tip(w, i)) ring.fit = RingFit::held;
    const Form* form = w.form(i);
    if (!form || form->kind != Form::Kind::ring) return;
    take_form(*form, ring);
    if (!form->fixed) {
        const Vec3 askew = out - in;
        const double cosine = std::sqrt(std::max(0.25, (1 + in.dot(out)) / 2));
        if (askew.norm() > 1e-9) ring.bend = (1 / cosine - 1) * askew.normalized();
    }
    ring.to_next = w.kind(i);
    if (ring.to_next == BoneKind::plate) ring.lines = 0;
}

bool leads_to_pit(const PathWork& w, std::int32_t bone) {
    const auto is_pit = [&](std::int32_t i) { return w.s.cap[w.node(i)] == Cap::pit; };
    return is_pit(bone) || is_pit(bone + 1);
}

}  // namespace

void place_rings(PathWork& w, bool keep_all) {
    w.kept.assign(w.count(), 1);
    w.bored.clear();
    if (!w.plain && !w.closed) find_bores(w);
    if (!keep_all && !w.closed) leave_out_nodes(w);
    w.rings.clear();
    if (!w.closed && !w.near.any()) add_end_rings(w, false);
    for (std::int32_t i = 0; i < w.count(); ++i) {
        if (w.is_inner(i) && w.kept[i]) add_at_node(w, i);
        if (i < w.bone_count() && w.kind(i) == BoneKind::tube && !leads_to_pit(w, i)) add_bone_rings(w, i);
    }
    if (!w.closed && !w.far.any()) add_end_rings(w, true);
}

}  // namespace sinew::sqm
