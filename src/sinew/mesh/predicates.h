/// @file predicates.h
/// Exact signs of determinants of float coordinates.
///
/// A filter in double precision decides nearly always; where it cannot, the determinant is summed exactly as
/// an expansion of doubles that do not overlap (J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic
/// and Fast Robust Geometric Predicates", 1997). Products of floats fit into doubles, which makes it short.
/// Needs finite coordinates.
#pragma once

#include "sinew/base/vec.h"

namespace sinew {

/// The sign of (a - d) . ((b - d) x (c - d)): -1, 0 or 1. Zero if and only if the four points are in one
/// plane.
int orient3d(const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d);

/// The sign of the area of the triangle a b c after the coordinate `axis` is dropped: 1 where it is
/// counter-clockwise in the plane of the coordinates axis + 1, axis + 2 (modulo 3).
int orient2d(const Vec3f& a, const Vec3f& b, const Vec3f& c, int axis);

/// An axis along which the triangle does not look like a line; -1 where its points are on one line.
int projection_axis(const Vec3f& a, const Vec3f& b, const Vec3f& c);

}  // namespace sinew
