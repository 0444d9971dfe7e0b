/// @file gizmo.h
/// Three arrows and three squares at the selection: handles of moves along and across the world's axes.
#pragma once

#include <optional>

#include "document/model.h"
#include "document/screen.h"
#include "tools/gesture.h"

namespace sinew::modeler {

inline constexpr double gizmo_arm = 78;     ///< pixels from the node to the tip of an arrow
inline constexpr double gizmo_start = 18;   ///< pixels from the node to where an arrow begins
inline constexpr double gizmo_square = 34;  ///< pixels along both axes to the middle of a square

/// One handle, as seen on the screen.
struct GizmoHandle {
    AxisLock lock;
    Vec2 from, to;  ///< of an arrow; a square has both in its middle
    double shown;   ///< 0..1: an arrow that points at the eye fades and cannot be taken
};

/// The handles at a point; none where it is behind the camera.
std::vector<GizmoHandle> gizmo_handles(const Screen& screen, const Vec3& at);

/// The handle under a pixel.
std::optional<AxisLock> gizmo_at(const Screen& screen, const Vec3& at, const Vec2& pixel);

}  // namespace sinew::modeler
