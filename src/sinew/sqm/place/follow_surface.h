/// @file follow_surface.h
/// The vertices of rings that follow a joint's surface (RingShape::follow).
#pragma once

#include "sinew/sqm/bridge/bridge.h"

namespace sinew::sqm {

/// A place between a vertex of the joint's own ring and the vertex of the next proper ring in its column: on
/// the joint's surface, along the great circle from the one to the other as seen from the joint's centre. On
/// the rim of a groove if both are there. Where both are seen in one direction, or in opposite ones, there is
/// no such circle: on the straight line between them.
/// @param end    the joint, and the slot that the path leaves it by
/// @param share  of the circle's arc, from the joint's own vertex on
Vec3 follow_surface(const Parts& parts, const PathEnd& end, const Vec3& at_joint, const Vec3& on_ring,
                    double share);

}  // namespace sinew::sqm
