/// @file bone_rings.h
/// The rings along one bone. Internal to the stations.
#pragma once

#include "sinew/sqm/rings/path_work.h"

namespace sinew::sqm {

/// Adds the rings of a bone in the path's order: one beside each joint, so that the tube keeps its radius
/// from there on, some where a steep cone touches the balls at its ends, and those that support a smooth
/// surface. None where the bone is too short for them.
void add_bone_rings(PathWork& w, std::int32_t bone);

}  // namespace sinew::sqm
