/// @file cubes.h
/// Cubes: boxes at joints, on paths and at their ends.
#pragma once

#include "sinew/extend/builder.h"

namespace sinew {

/// On a bone or at its end: rings at two faces. At a root, a branch or alone: a box joint with six faces.
/// Cubes that touch or overlap face to face share what is between them (contacts.h).
void add_cube(PlainBuilder& builder, std::int32_t node);

}  // namespace sinew
