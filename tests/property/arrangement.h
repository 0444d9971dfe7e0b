/// @file arrangement.h
/// How a skeleton lies in space, as far as it says what may be asked of its mesh.
#pragma once

#include "sinew/extend/plain.h"
#include "sinew/skeleton/document.h"

namespace sinew::property {

/// Nothing but balls and cones, as they are by default, and no symmetry drawn.
bool is_plain(const Document& document);

/// The least angle between two bones at one node, in radians; 0 where a bone has no length.
double least_angle(const Document& document);
double least_angle(const Plain& skeleton);

/// Is the skeleton its own image in the plane across an axis? Not if two of its nodes cannot be told apart.
bool is_own_image(const Document& document, int axis);

/// Are all nodes in the plane across an axis?
bool is_flat(const Document& document, int axis);

}  // namespace sinew::property
