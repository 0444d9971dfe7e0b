#include "sinew/extend/bodies.h"

#include <algorithm>
#include <cmath>

#include "sinew/base/round_cone.h"
#include "sinew/extend/body_forms.h"
#include "sinew/extend/sections.h"

namespace sinew {
namespace {

constexpr int pit_sides = 8;  // round a dent: with fewer, the surface beside it is pulled out of shape

// Cosine of 50 degrees: an axis with no bone nearer than that gets one of its own. A bone towards a corner of
// the frame is 54.7 degrees from three axes and has bones on all of them; one that leans away from an axis
// takes its place. Of 216 dents and 300 balls with random tubes 24 and 210 had a folded quad with it; 27 and
// 217 with 45 degrees; with 55 degrees (21 and 206) seven of 72 bowls crossed themselves, where now one does.
constexpr double bare = 0.643;

// What rounding may add to the cosine of a ray that is turned right to the border of what is bare.
constexpr double rounding = 1e-9;

// A joint with a body of its own has at least as many bones: fewer have no cells round them.
constexpr std::int32_t least_bones = 3;

// Of a dent's width: where its cell ends at the nearest. Inside the rim bowls fold
// (FoldsNothingHoweverWideTheBowl fails at 0.97); beyond it nothing changes up to 1.2, and the twentieth is
// for what single precision takes away.
constexpr double beyond_rim = 1.05;

// Of a ball's smallest radius: the circle of the widest tube, 64 degrees from its axis. What is left to the
// other side of the ball narrows quickly from there on: 77 degrees at 0.975.
constexpr double widest_limb = 0.9;

// Of its parent's radius, and of its parent's thickness: what a dent leaves is a wall that one can see. Of 72
// bowls one crossed itself with 0.9, and three from 0.93 on; the depth matters to nobody up to 0.95.
constexpr double widest_dent = 0.9, deepest_dent = 0.85;

// Of the height of a ball's circle: a bone that is no longer than that has no direction in single precision.
constexpr double no_bone = 1e-6;

// Of its own radius, for a dent that was drawn inside its parent: enough to be seen, so that the warning is
// understood.
constexpr double shallow_dent = 0.1;

/// The cell of a dent ends halfway to the next bone: if that were not beyond the dent's rim, the joint would
/// fold over it. Turns a ray so far away from the dent, where it can.
Vec3 clear_of_dent(const PlainBuilder& b, std::int32_t node, std::int32_t dent, double reach,
                   const Vec3& ray) {
    const double rim =
        beyond_rim * section_form(b, dent).half.head<2>().maxCoeff() / reach;  // sine of its angle
    const double cosine = std::max(1 - 2 * rim * rim, -bare);
    const Vec3 towards = b.direction(node, dent), across = ray - ray.dot(towards) * towards;
    if (ray.dot(towards) <= cosine) return ray;
    return cosine * towards + std::sqrt(1 - cosine * cosine) * across.normalized();
}

/// Bones of its own for every axis that no drawn bone is near, so that the joint has vertices all round, and
/// where dents leave no room for that, as many as it needs.
void add_surface_bones(PlainBuilder& b, std::int32_t node, const Frame& frame, double reach) {
    std::vector<std::int32_t> drawn;
    std::vector<Vec3> taken;
    for (const std::int32_t bone : b.bones(node)) {
        drawn.push_back(b.other(bone, node));
        taken.push_back(b.direction(node, drawn.back()));
    }
    const std::vector<Vec3> of_drawn = taken;
    const auto nearness = [](const std::vector<Vec3>& rays, const Vec3& ray) {
        double most = -1;  // a cosine
        for (const Vec3& other : rays) most = std::max(most, other.dot(ray));
        return most;
    };
    const auto add = [&](const Vec3& ray) {
        const std::int32_t tip = b.add_node(b.position(node) + reach * ray, 0.5 * reach, node);
        b.set_cap(tip, Cap::surface);
        b.add_bone(node, tip, BoneKind::body);
        taken.push_back(ray);
    };
    for (const Vec3& axis : {frame.x, frame.y, frame.z})
        for (const double sign : {1.0, -1.0}) {
            const Vec3 straight = sign * axis;
            if (nearness(of_drawn, straight) > bare) continue;
            Vec3 ray = straight;  // dents on both sides push alike, in whatever order they are drawn
            for (const std::int32_t other : drawn)
                if (b.is_pit(other)) ray += clear_of_dent(b, node, other, reach, straight) - straight;
            const bool pushed_both_ways = ray.norm() <= 0.5;  // there is no way left that is clear of all
            ray = pushed_both_ways ? straight : Vec3(ray.normalized());
            if (nearness(of_drawn, ray) <= bare + rounding) add(ray);
        }
    while (std::ssize(taken) < least_bones) {  // ends: each turn adds one
        Vec3 loneliest = frame.x;
        for (const Vec3& axis : {frame.x, frame.y, frame.z})
            for (const Vec3& ray : {axis, Vec3(-axis)})
                if (nearness(taken, ray) < nearness(taken, loneliest)) loneliest = ray;
        add(loneliest);
    }
}

/// Where a unit ray from the middle of a node leaves its own surface.
double exit_of_node(const PlainBuilder& b, std::int32_t node, const Vec3& ray) {
    if (const Form* form = b.form(node); form && form->kind == Form::Kind::box)
        return exit_of_box(*form, ray);
    if (const Form* form = b.form(node); form && form->kind == Form::Kind::ball)
        return exit_of_ellipsoid(*form, ray);
    double distance = b.radius(node);
    for (const std::int32_t bone : b.bones(node)) {
        const std::int32_t other = b.other(bone, node);
        if (b.is_pit(other)) continue;
        distance = std::max(
            distance,
            ConeFrom(b.position(node), b.radius(node), b.position(other), b.radius(other)).exit(ray));
    }
    return distance;
}

/// A dent as wide as what it is pressed into would leave nothing of it.
bool narrow(double& half, double parent) {
    if (half < parent) return false;
    half = widest_dent * parent;
    return true;
}

}  // namespace

void add_ball(PlainBuilder& b, std::int32_t node) {
    const auto& scale = b.drawn(node).scale;
    const Form ball =
        body_form(b, node, Form::Kind::ball, b.radius(node) * Vec3(scale[0], scale[1], scale[2]));
    b.set_form(node, ball);
    if (b.degree(node) == 0) return;
    for (const std::int32_t bone : b.bones(node)) {
        const std::int32_t neighbour = b.other(bone, node);
        if (b.is_pit(neighbour)) continue;
        const Vec3 ray = b.direction(node, neighbour);
        const double reach = exit_of_ellipsoid(ball, ray),
                     tube = std::min(b.radius(neighbour), widest_limb * ball.half.minCoeff());
        const double height = reach * std::sqrt(1 - (tube / reach) * (tube / reach));
        const double distance = (b.position(neighbour) - b.position(node)).norm();
        if (distance <= height * (1 + no_bone)) continue;  // the other end is inside the ball
        const std::int32_t ring = b.add_node(b.position(node) + height * ray, tube, node);
        b.set_form(ring, ring_form(frame_along(ray, 0), tube, tube, Section::round, ball.sharpness));
        b.add_bone(node, ring, BoneKind::body);
        b.attach(bone, node, ring);
    }
    add_surface_bones(b, node, {ball.x, ball.y, ball.z}, ball.half.mean());
}

void add_pit(PlainBuilder& b, std::int32_t node) {
    const std::int32_t parent = b.other(b.bones(node)[0], node);
    const Vec3 ray = b.direction(parent, node);
    const double surface = exit_of_node(b, parent, ray), room = surface + exit_of_node(b, parent, -ray);
    double depth = (b.position(node) - b.position(parent)).norm() - surface;
    if (depth <= 0) {
        b.warn(node, "this negative leaf lies inside its parent; its dent is made shallow");
        depth = shallow_dent * b.radius(node);
    }
    if (depth > deepest_dent * room) {
        b.warn(node,
               "this negative leaf is deeper than its parent is thick; its dent ends before the far side");
        depth = deepest_dent * room;
    }
    Form opening = section_form(b, node);
    const auto wide = [&](const Vec3& axis) {
        return std::min(exit_of_node(b, parent, axis), exit_of_node(b, parent, -axis));
    };
    const bool narrowed_x = narrow(opening.half.x(), wide(opening.x));
    const bool narrowed_y = narrow(opening.half.y(), wide(opening.y));
    if (narrowed_x || narrowed_y)
        b.warn(node, "this negative leaf is wider than its parent; its dent leaves a wall round it");
    opening.sides = pit_sides;
    b.set_form(node, opening);
    b.set_pit(node, depth);
    b.move(node, b.position(parent) + (surface + depth) * ray);
    const bool needs_body = !b.form(parent) || b.form(parent)->kind == Form::Kind::ring;
    if (!needs_body) return;
    b.set_cap(parent, Cap::round);  // a leaf of which nothing is left but its dent ends nowhere
    b.set_radius(parent, b.radius(parent));
    Form blend = b.form(parent) ? *b.form(parent) : section_form(b, parent);
    blend.kind = Form::Kind::blend;
    blend.sides = pit_sides;
    b.set_form(parent, blend);
    add_surface_bones(b, parent, b.frame(parent), b.radius(parent));
}

}  // namespace sinew
