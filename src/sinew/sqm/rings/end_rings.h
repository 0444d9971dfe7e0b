/// @file end_rings.h
/// The rings where a path ends at a leaf: of a round or flat end, or down a dent. Internal to the stations.
#pragma once

#include "sinew/sqm/rings/path_work.h"

namespace sinew::sqm {

/// Adds the rings of the path's first or last leaf, in the path's order; tips of cones have none.
void add_end_rings(PathWork& w, bool at_end);

}  // namespace sinew::sqm
