/// @file begin_gesture.h
/// Which gesture a drag or a key begins.
#pragma once

#include <memory>
#include <optional>

#include "document/model.h"
#include "document/pick.h"
#include "document/snap.h"
#include "tools/gesture.h"

namespace sinew::modeler {

/// What a drag from a node does: draw a child of it, move it, change its radius.
enum class Tool : std::uint8_t { draw, move, radius };

/// Gestures that a key begins; they follow the pointer until the next click.
enum class Modal : std::uint8_t { extrude, move, radius, duplicate, link };

/// Where the button went down, and on what.
struct Press {
    Pointer pointer;
    Hit hit;
    std::optional<AxisLock> handle;  ///< of the gizmo
};

/// What a drag takes along: the selection where the node belongs to it, else the node (the ends, for a bone).
Selection grabbed(const Model& model, const Hit& hit);

/// From nothing a box; from the gizmo a move along or across an axis; from a node or a bone what the tool and
/// the keys held at the press say.
std::unique_ptr<Gesture> begin_drag(Model& model, Tool tool, SnapTo snap_to, const Press& press,
                                    const Screen& screen);

/// At what is selected, of which there is something.
std::unique_ptr<Gesture> begin_modal(Model& model, Modal modal, SnapTo snap_to, const Pointer& pointer,
                                     const Screen& screen);

}  // namespace sinew::modeler
