/// @file features.h
/// What must stay true of the mesh: creases, corners, circles and planes of flat ends, boxes, sections and
/// sharp joints.
#pragma once

#include "sinew/sqm/bridge/bridge.h"

namespace sinew::sqm {

/// Fills bridge.mesh.features, beside the poles that are there. Indices come from the layout, places from the
/// rings.
void add_features(const Parts& parts, Bridge& bridge);

}  // namespace sinew::sqm
