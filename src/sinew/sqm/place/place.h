/// @file place.h
/// Stage 4: every vertex is put on the ideal surface.
///
/// In: all earlier results. Out: positions, and which node and bone each vertex came from. Joint points lie
/// there already; rings are circles on straight tubes and the cut through both round cones at nodes where a
/// path bends. Rings too wide for the cell of the joint that their bone leaves are pulled into it. Cannot
/// fail.
#pragma once

#include "sinew/sqm/bridge/bridge.h"

namespace sinew::sqm {

struct PlaceOptions {
    bool ideal =
        true;  ///< false: joint points stay on the balls of their joints and rings are circles, as bridged
};

/// Sets positions and origins of bridge.mesh.
void place(const Parts& parts, const PlaceOptions& options, Bridge& bridge);

}  // namespace sinew::sqm
