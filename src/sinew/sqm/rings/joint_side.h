/// @file joint_side.h
/// What a joint takes of a path that leaves it. Internal to the stations.
#pragma once

#include "sinew/sqm/rings/path_work.h"

namespace sinew::sqm {

/// Fills `side` with the joint's ring at one end of the path, and with how far the joint reaches along the
/// path's bone: as far as its points, and to where the tube has left those of its neighbours.
void take_joint(const PathWork& w, const PathEnd& end, bool is_far, JointSide& side);

}  // namespace sinew::sqm
