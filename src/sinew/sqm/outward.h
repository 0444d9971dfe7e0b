/// @file outward.h
/// The last look at a mesh: no component of it is inside out.
#pragma once

#include <cstdint>

#include "sinew/sqm/bridge/bridge.h"

namespace sinew::sqm {

/// Turns every component whose signed volume is negative: the corners of its faces are taken the other way
/// round, each from the same first one, and the planes among its features get the opposite normals. A joint
/// that a neighbour's ball swallows, or a tube folded back into another, can enclose more space from the
/// wrong side than from the right one; such a mesh is closed all the same, and outward once it is turned.
///
/// In: the parts and the bridge with its final positions. Volumes are those of the positions in single
/// precision, summed in double precision; where rounding could decide the sign they are summed in the order
/// in which validate() does it. A component without volume is left as it is. Linear, the same on any number
/// of threads; cannot fail.
/// @return how many components were turned
std::int64_t turn_outward(const Parts& parts, Bridge& bridge);

}  // namespace sinew::sqm
