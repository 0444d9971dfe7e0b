/// @file fit.h
/// Control points whose smooth surface has the radii.
///
/// A closed cubic B-spline of n points has less than their radius, (4 + 2 cos(2 pi / n)) / 6 of it. Points
/// move out, along rays of their joint or in the plane of their ring, until the limit surface is where the
/// points were: never along a tube, where being elsewhere on the surface is no error and uneven rings would
/// drive each other apart.
#pragma once

#include "sinew/sqm/bridge/bridge.h"

namespace sinew::sqm {

/// @param bridge  with all faces and features; its positions, on the ideal surface, become those of the
/// control points. Fails only if the limit surface of the mesh cannot be found.
Result<void> fit_limit(const Parts& parts, Bridge& bridge);

}  // namespace sinew::sqm
