/// @file bodies.h
/// Balls and pits: node types that become several plain nodes.
#pragma once

#include "sinew/extend/builder.h"

namespace sinew {

/// A ball joint: every tube leaves it with the radius of its other end; bare parts get bones of their own.
void add_ball(PlainBuilder& builder, std::int32_t node);

/// A negative leaf: a dent in its parent. The node stands outside, as far as the dent is deep.
void add_pit(PlainBuilder& builder, std::int32_t node);

}  // namespace sinew
