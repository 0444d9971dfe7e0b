#include "sinew/grow/turtle.h"

#include <fmt/format.h>

#include <cmath>

#include "sinew/base/portable_math.h"
#include "sinew/skeleton/frames.h"
#include "sinew/skeleton/graph.h"

namespace sinew::lsystem {
namespace {

/// Turns a towards b by an angle in degrees; both stay perpendicular.
void turn(Vec3& a, Vec3& b, double degrees) {
    const double c = portable::cosine(degrees), s = portable::sine(degrees);
    const Vec3 old = a;
    a = c * a + s * b;
    b = c * b - s * old;
}

constexpr std::size_t deepest = 1'000'000;

bool positive(double x) { return std::isfinite(x) && x > 0; }

bool for_leaves(NodeType type) {
    return type == NodeType::cone || type == NodeType::hemisphere || type == NodeType::negative;
}

}  // namespace

Turtle::Turtle(const TurtleDefaults& defaults, std::int64_t limit, std::int64_t room)
    : defaults_(defaults), limit_(limit) {
    document_.nodes.reserve(static_cast<std::size_t>(room));
    state_.radius = defaults.radius;
    state_.tropism = defaults.tropism;
    state_.bending = defaults.bending;
    state_.node = -1;
    places_.push_back(-1);
}

bool Turtle::fail(std::string what) {
    wrong_ = std::move(what);
    return false;
}

bool Turtle::obey(Command command, const double* arguments, int count) {
    State& s = state_;
    const double angle = count > 0 ? arguments[0] : defaults_.angle;
    const double length = count > 0 ? arguments[0] : defaults_.length;
    switch (command) {
        case Command::none:
        case Command::cut:
            return true;
        case Command::draw:
            return draw(length);
        case Command::move:
            return move(length);
        case Command::node:
            return put_node();
        case Command::turn_left:
            return turn(s.heading, s.left, angle), true;
        case Command::turn_right:
            return turn(s.heading, s.left, -angle), true;
        case Command::pitch_up:
            return turn(s.heading, s.up, angle), true;
        case Command::pitch_down:
            return turn(s.heading, s.up, -angle), true;
        case Command::roll_right:
            return turn(s.left, s.up, angle), true;
        case Command::roll_left:
            return turn(s.left, s.up, -angle), true;
        case Command::turn_around:
            return turn(s.heading, s.left, 180), true;
        case Command::level:
            return make_level(), true;
        case Command::radius:
            return set_radius(count > 0 ? arguments[0] : s.radius * defaults_.thinning);
        case Command::push:
            return push();
        case Command::pop:
            return s = stack_.back(), stack_.pop_back(), true;
        case Command::round:
            return s.section = Section::round, true;
        case Command::rectangular:
            return s.section = Section::rectangular, true;
        case Command::scale:
            return set_scale(arguments, count);
        case Command::tropism:
            return set_tropism(arguments, count), true;
        case Command::sphere:
            return s.next.type = NodeType::sphere, true;
        case Command::cone:
            return s.next.type = NodeType::cone, true;
        case Command::hemisphere:
            return s.next.type = NodeType::hemisphere, true;
        case Command::cube:
            return set_cube(arguments, count);
        case Command::negative:
            return s.next.type = NodeType::negative, true;
        case Command::ball:
            return s.next.type = NodeType::ball, true;
        case Command::joint:
            return set_joint(arguments[0]);
        case Command::sharp:
            return set_joint(infinitely_sharp);
    }
    return true;
}

bool Turtle::push() {
    if (stack_.size() >= deepest) return fail("opens more branches inside each other than can be kept");
    stack_.push_back(state_);
    return true;
}

bool Turtle::draw(double length) {
    if (length == 0) return true;
    if (state_.node < 0) {
        std::int32_t& made = places_[-1 - state_.node];
        if (made < 0) made = add_node(-1, {});
        state_.node = made;
    }
    state_.position += length * state_.heading;
    if (!(state_.position.cwiseAbs().maxCoeff() < 1e30))
        return fail("leads out of the numbers that a skeleton can have");
    state_.node = add_node(state_.node, state_.next);
    state_.next = {};
    bend();
    return true;
}

bool Turtle::move(double length) {
    if (length == 0) return true;
    state_.position += length * state_.heading;
    if (!(state_.position.cwiseAbs().maxCoeff() < 1e30))
        return fail("leads out of the numbers that a skeleton can have");
    state_.node = -1 - static_cast<std::int32_t>(places_.size());
    places_.push_back(-1);
    return true;
}

bool Turtle::put_node() {
    if (state_.node >= 0) return true;
    std::int32_t& made = places_[-1 - state_.node];
    if (made < 0) made = add_node(-1, state_.next);
    state_.node = made;
    state_.next = {};
    return true;
}

std::int32_t Turtle::add_node(std::int32_t parent, const Next& next) {
    const auto index = static_cast<std::int32_t>(count_++);
    if (count_ > limit_) return index;
    Node& node = document_.nodes.emplace_back();
    node.id = index;
    node.parent = parent;
    node.position = state_.position;
    node.radius = state_.radius;
    node.type = next.type;
    node.section = state_.section;
    node.scale = state_.scale;
    node.size = next.size;
    node.joint = next.joint;
    const bool plain = (next.type == NodeType::sphere || for_leaves(next.type)) &&
                       state_.section == Section::round && state_.scale[0] == 1 && state_.scale[1] == 1;
    if (!plain) frames_.push_back({index, state_.left, state_.up, state_.heading});
    return index;
}

bool Turtle::set_radius(double radius) {
    if (!positive(radius)) return fail("sets a radius that is not above 0");
    state_.radius = radius;
    return true;
}

bool Turtle::set_scale(const double* arguments, int count) {
    state_.scale = {arguments[0], arguments[1], count > 2 ? arguments[2] : 1};
    for (double factor : state_.scale)
        if (!positive(factor)) return fail("sets a scale that is not above 0");
    return true;
}

bool Turtle::set_cube(const double* arguments, int count) {
    state_.next.type = NodeType::cube;
    state_.next.size.reset();
    if (count < 3) return true;
    state_.next.size = Vec3(arguments[0], arguments[1], arguments[2]);
    return state_.next.size->minCoeff() > 0 || fail("sets a size that is not above 0");
}

void Turtle::set_tropism(const double* arguments, int count) {
    if (count == 4) state_.tropism = Vec3(arguments[0], arguments[1], arguments[2]);
    state_.bending = arguments[count - 1];
}

bool Turtle::set_joint(double sharpness) {
    state_.next.joint = sharpness;
    return sharpness >= 0 || fail("sets a sharpness below 0");
}

/// Section 2.2.2 of the book: H turns towards T by e |H x T| radians after each segment.
void Turtle::bend() {
    if (state_.bending == 0) return;
    const Vec3 torque = state_.heading.cross(state_.tropism);
    const double strength = torque.norm();
    if (strength == 0) return;
    const Vec3 axis = torque / strength;
    const double angle = state_.bending * strength * 57.295779513082321;
    const double c = portable::cosine(angle), s = portable::sine(angle);
    for (Vec3* v : {&state_.heading, &state_.left, &state_.up})
        *v = c * *v + s * axis.cross(*v) + (1 - c) * axis.dot(*v) * axis;
}

/// $: L becomes horizontal, H stays.
void Turtle::make_level() {
    const Vec3 left = Vec3(-state_.heading.y(), state_.heading.x(), 0);
    if (left.norm() < 1e-9) return;
    state_.left = left / left.norm();
    state_.up = state_.heading.cross(state_.left);
}

/// Leaf types are kept at leaves; other nodes that were drawn with one are spheres.
void Turtle::keep_leaf_types() {
    std::vector<std::int32_t> bones(document_.nodes.size(), 0);
    for (const Node& node : document_.nodes)
        if (node.parent >= 0) ++bones[node.id], ++bones[node.parent];
    for (Node& node : document_.nodes)
        if (for_leaves(node.type) && bones[node.id] != 1) node.type = NodeType::sphere;
}

/// The turtle's frame (x left, y up, z heading) as what the format has for it: a rotation for cubes and balls
/// at a root or a branch, else the roll that brings x closest.
void Turtle::write_frames() {
    const auto bones = bones_of(document_);
    const Adjacency neighbours = adjacency(static_cast<std::int32_t>(document_.nodes.size()), bones);
    for (const Frame& frame : frames_) {
        Node& node = document_.nodes[frame.node];
        const bool turnable = node.type == NodeType::cube || node.type == NodeType::ball;
        if (turnable && (node.parent < 0 || neighbours.degree(frame.node) > 2)) {
            Mat3 axes;
            axes << frame.left, frame.up, frame.heading;
            node.rotation = Quat(axes);
            continue;
        }
        const Mat3 unrolled = local_frame(document_, bones, neighbours, frame.node);
        node.roll = portable::arc_tangent(frame.left.dot(unrolled.col(1)), frame.left.dot(unrolled.col(0)));
    }
}

Document Turtle::finish() {
    keep_leaf_types();
    if (!frames_.empty()) write_frames();
    return std::move(document_);
}

}  // namespace sinew::lsystem
