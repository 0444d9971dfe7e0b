/// @file bodies.h
/// Balls and pits: node types that become several plain nodes.
#pragma once

#include "sinew/extend/builder.h"

namespace sinew {

/// A ball joint: every tube leaves it with the radius of its other end; bare parts get bones of their own.
void add_ball(PlainBuilder& builder, std::int32_t node);

/// A negative leaf: a dent in its parent. The node stands outside, as far as the dent is deep.
void add_pit(PlainBuilder& builder, std::int32_t node);

/// Distance from the centre to where a unit ray leaves an ellipsoid or a box with a form's axes and half
/// extents.
double exit_of_ellipsoid(const Form& form, const Vec3& ray);
double exit_of_box(const Form& form, const Vec3& ray);

}  // namespace sinew
