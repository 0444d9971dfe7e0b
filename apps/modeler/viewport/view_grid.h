/// @file view_grid.h
/// The grid behind views along an axis: its lines are what Ctrl snaps to.
#pragma once

#include "document/screen.h"
#include "sinew/render/camera.h"

class QPainter;

namespace sinew::modeler {

/// The axis that a camera looks along (0, 1, 2 for x, y, z), or -1 for none.
int axis_seen_along(const Camera& camera);

/// Nothing in perspective or from any other direction.
void paint_view_grid(QPainter& painter, const Camera& camera, const Screen& screen);

}  // namespace sinew::modeler
