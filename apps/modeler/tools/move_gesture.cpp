#include "tools/move_gesture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "document/images.h"

namespace sinew::modeler {
namespace {

const double edge_on = 0.1;    ///< sine of the angle at which one looks along a plane
const double farthest = 1e12;  ///< from the origin: what nobody means, such as the horizon's other side

}  // namespace

MoveGesture::MoveGesture(Model& model, MoveStart start, const Pointer& pointer)
    : model_(model), start_(std::move(start)), pressed_at_(pointer.pixel) {
    const Node& anchor = start_.edit.document.nodes[start_.anchor];
    anchor_position_ = target_ = anchor.position;
    if (anchor.parent >= 0 && !start_.edit.selection.contains(anchor.parent))
        parent_position_ = start_.edit.document.nodes[anchor.parent].position;
    model_.preview(start_.edit.document, start_.edit.selection);
}

/// The locked axis in the document: in an image of a radial symmetry the world's X is turned.
Vec3 MoveGesture::lock_direction() const { return start_.image.transpose() * Vec3::Unit(start_.lock.axis); }

/// Where the pointer leads without any snap, from the anchor's first place.
Vec3 MoveGesture::free_delta(const Screen& screen, const Vec2& pixel) const {
    const Ray before = screen.ray(pressed_at_), now = screen.ray(pixel);
    std::optional<Vec3> from, to;
    if (start_.lock.axis >= 0 && !start_.lock.plane) {
        from = nearest_on_line(before, anchor_position_, lock_direction());
        to = nearest_on_line(now, anchor_position_, lock_direction());
    } else {
        // A plane that is seen edge-on gives no hold; locked() takes out what leads away from it.
        const Vec3 ahead = screen.forward(anchor_position_);
        const bool usable = start_.lock.plane && std::abs(lock_direction().dot(ahead)) > edge_on;
        const Vec3 normal = usable ? lock_direction() : ahead;
        from = meet_plane(before, anchor_position_, normal);
        to = meet_plane(now, anchor_position_, normal);
    }
    return from && to ? Vec3(*to - *from) : Vec3(target_ - anchor_position_);
}

Snapped MoveGesture::snap(const Screen& screen, const Pointer& pointer, const Vec3& target) const {
    const Document& document = start_.edit.document;
    const std::vector<std::int32_t>& moving = start_.edit.selection.nodes;
    if (pointer.ctrl)
        if (auto node = node_near(document, moving, screen, target)) return {*node, true};
    // A single node keeps to the mirror's plane on its own: half of what one draws starts there.
    const bool sticks = pointer.ctrl || moving.size() == 1;
    const Snapped near =
        sticks ? onto_near_symmetry(document.symmetry, screen, target) : Snapped{target, false};
    if (!pointer.ctrl) return near;
    const bool by_angle = parent_position_ && (start_.snap_to == SnapTo::angle || pointer.shift);
    const Vec3 round = by_angle ? onto_angle(near.position, *parent_position_, screen.forward(target))
                                : onto_grid(near.position, grid_step(screen, anchor_position_));
    return {near.caught ? onto_symmetry(document.symmetry, round) : round, near.caught};
}

/// What is left of a move under the axis lock.
Vec3 MoveGesture::locked(const Vec3& target) const {
    if (start_.lock.axis < 0) return target;
    const Vec3 axis = lock_direction();
    const Vec3 along = axis * axis.dot(target - anchor_position_);
    return start_.lock.plane ? Vec3(target - along) : Vec3(anchor_position_ + along);
}

Vec3 MoveGesture::exact_delta(const Vec3& delta) const {
    if (start_.lock.axis >= 0 && !start_.lock.plane) return *amount_ * lock_direction();
    return delta.norm() > 0 ? Vec3(*amount_ * delta.normalized()) : delta;
}

void MoveGesture::update(const Pointer& pointer, const Screen& screen) {
    const Screen here = screen.in_image(start_.image);
    const Vec3 delta = free_delta(here, pointer.pixel);
    const Snapped snapped = snap(here, pointer, anchor_position_ + delta);
    caught_ = snapped.caught && !amount_;
    const Vec3 target = amount_ ? Vec3(anchor_position_ + exact_delta(delta)) : locked(snapped.position);
    if (target.cwiseAbs().maxCoeff() <= farthest) target_ = target;
    Document next = start_.edit.document;
    for (std::int32_t node : start_.edit.selection.nodes) {
        const Vec3 offset = start_.edit.document.nodes[node].position - anchor_position_;
        next.nodes[node].position = target_ + offset;
    }
    model_.preview(std::move(next), start_.edit.selection);
}

void MoveGesture::finish() { model_.commit(start_.label); }

bool MoveGesture::lock(const AxisLock& lock) {
    start_.lock = lock == start_.lock ? AxisLock{} : lock;
    return true;
}

bool MoveGesture::set_amount(std::optional<double> amount) {
    amount_ = amount;
    return true;
}

std::string MoveGesture::hint() const {
    const std::string unit = model_.document().unit.empty() ? "" : " " + model_.document().unit;
    const Vec3 delta = target_ - anchor_position_;
    std::string text = fmt::format("{}: {:.4g}{}", start_.label, delta.norm(), unit);
    text += fmt::format("  ({:.4g}, {:.4g}, {:.4g})", delta.x(), delta.y(), delta.z());
    if (start_.lock.axis >= 0)
        text += fmt::format("  {} {}", start_.lock.plane ? "across" : "along", "XYZ"[start_.lock.axis]);
    return text;
}

Guides MoveGesture::guides() const {
    Guides guides;
    const Vec3 from = start_.image * anchor_position_;
    const double reach = 1e3 * std::max(1.0, from.norm());
    for (int axis = 0; axis < 3; ++axis) {
        const bool shown = start_.lock.axis >= 0 && (axis == start_.lock.axis) != start_.lock.plane;
        const Vec3 way = reach * Vec3::Unit(axis);
        if (shown) guides.lines.push_back({from - way, from + way, axis});
    }
    if (caught_) guides.snapped = start_.image * target_;
    return guides;
}

}  // namespace sinew::modeler
