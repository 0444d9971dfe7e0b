/// @file path_rings.h
/// Where the rings of a path stand, and what outlines they have. Internal to the stations.
#pragma once

#include "sinew/sqm/rings/path_work.h"

namespace sinew::sqm {

/// Rings along the path, from its start to its end, but for the follow rings. Those at nodes inside the part
/// of a joint are left out.
/// @param keep_all  leaves out none at nodes
void place_rings(PathWork& w, bool keep_all);

}  // namespace sinew::sqm
