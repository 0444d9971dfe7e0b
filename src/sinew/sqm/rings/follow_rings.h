/// @file follow_rings.h
/// Rings between a joint and the first ring of a path. Internal to the stations.
#pragma once

#include "sinew/sqm/rings/path_work.h"

namespace sinew::sqm {

/// Where the faces between a joint and the first ring would cut off much of the joint's surface, rings follow
/// it.
void add_follow_rings(PathWork& work);

}  // namespace sinew::sqm
