/// @file dent_rings.h
/// The vertices of a dent: its rim, the rings down its wall, and its bottom.
#pragma once

#include "sinew/sqm/bridge/bridge.h"

namespace sinew::sqm {

/// Places the rings of shape RingShape::pit of a path. The rim is the opening that was drawn. Where another
/// dent overlaps this one each column goes towards the vertex of the cell's border that it ends in, as far as
/// the groove does: the floor goes on from one to the other without a fold.
void place_dent_rings(const Parts& parts, std::int32_t path, Bridge& bridge);

/// The bottom of the dent that a path ends in, beyond a joint.
Vec3 bottom_of_dent(const Parts& parts, const PathEnd& joint);

}  // namespace sinew::sqm
