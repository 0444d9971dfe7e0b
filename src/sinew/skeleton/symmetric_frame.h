/// @file symmetric_frame.h
/// How a node that is its own image must be turned, so that its shape is its own image too.
#pragma once

#include "sinew/base/vec.h"
#include "sinew/skeleton/document.h"

namespace sinew {

/// The frame nearest to a given one that the symmetry maps onto itself up to what no box or ellipsoid shows:
/// half turns, and axes of equal extents that change places. The frame itself where it is so already, or
/// where there is none: a box does not look alike after a fifth of a turn. Only one that bones hold upright
/// is turned to have edges in the mirror: through those of others tubes would leave.
/// @param frame   a rotation
/// @param extents along the frame's x, y and z; only whether they are equal counts, and 0 along the z of a
///                section
/// @param upright z stays as it is: the frame may only roll
Mat3 symmetric_frame(const Mat3& frame, const Vec3& extents, const Symmetry& symmetry, bool upright);

}  // namespace sinew
