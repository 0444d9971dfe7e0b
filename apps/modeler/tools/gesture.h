/// @file gesture.h
/// One thing that a person does with the pointer from beginning to end: a move, a change of radius, a box.
///
/// Gestures preview in the model while they run and leave one undo step, or none.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "document/screen.h"
#include "tools/pointer.h"

namespace sinew::modeler {

/// Which way a move may go: anywhere in the view plane, along an axis, or across one.
struct AxisLock {
    int axis = -1;       ///< 0, 1, 2; -1: free
    bool plane = false;  ///< in the plane across the axis instead of along it

    bool operator==(const AxisLock&) const = default;
};

/// What a gesture wants drawn over the scene. Points are as shown, in the image where the gesture takes
/// place.
struct Guides {
    struct Line {
        Vec3 from, to;
        int axis = -1;  ///< for its colour; -1: neutral
    };
    std::vector<Line> lines;
    std::optional<Vec3> snapped;                   ///< what Ctrl, or the mirror's plane, caught
    std::optional<std::array<Vec2, 2>> rectangle;  ///< corners in pixels
};

class Gesture {
  public:
    virtual ~Gesture() = default;
    /// The pointer moved, or a modifier changed.
    virtual void update(const Pointer& pointer, const Screen& screen) = 0;
    /// Keeps what is previewed, as one step.
    virtual void finish() = 0;
    /// Leaves everything as it was before.
    virtual void cancel() = 0;
    /// @return false where the gesture has no axes
    virtual bool lock(const AxisLock&) { return false; }
    /// An exact amount in place of the pointer's; nothing goes back to the pointer.
    virtual bool set_amount(std::optional<double>) { return false; }
    /// Over the scene: what is going on, in figures.
    virtual std::string hint() const = 0;
    /// For the status line: what keys do meanwhile.
    virtual std::string keys() const = 0;
    virtual Guides guides() const { return {}; }
};

}  // namespace sinew::modeler
