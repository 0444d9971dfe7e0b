/// @file ring_support.h
/// Where a smooth surface swings out unless rings hold it. Internal to the stations.
#pragma once

#include "sinew/sqm/rings/path_work.h"

namespace sinew::sqm {

/// Whether a path narrows to a tip from this node on, with a corner of its own at the node.
bool is_base_of_tip(const PathWork& w, std::int32_t i);

/// Whether this node is a round end, the base of a tip or a sharp bend, and rings were asked for beside
/// those (StationOptions::support).
bool wants_support(const PathWork& w, std::int32_t i);

}  // namespace sinew::sqm
