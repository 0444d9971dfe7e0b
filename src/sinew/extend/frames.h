/// @file frames.h
/// The local frame of a node, as the format defines it: a file means one shape.
#pragma once

#include "sinew/base/vec.h"

namespace sinew {

struct Frame {
    Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
};

/// z as given (unit); x the world's X, or Y where |z.X| > 0.9, made orthogonal to z; y = z x x; then `roll`
/// degrees about z.
Frame frame_along(const Vec3& z, double roll);

/// Turns the vector (right angles to z from) into the one at right angles to z `to`, with the least rotation.
Frame turn_frame(const Frame& frame, const Vec3& to);

}  // namespace sinew
