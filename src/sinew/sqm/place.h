/// @file place.h
/// Stage 4: every vertex is put on the ideal surface.
///
/// In: all earlier results. Out: positions, and which node and bone each vertex came from. Joint points lie
/// there already; rings are circles on straight tubes and the cut through both round cones at nodes where a
/// path bends. Rings too wide for the cell of the joint that their bone leaves are pulled into it. With a
/// symmetry the positions are made symmetric to the last bit. With Fit::limit the control points are moved
/// until the smooth surface, not the control mesh, passes through the points found here.
#pragma once

#include "sinew/sqm/bridge.h"
#include "sinew/sqm/symmetry.h"

namespace sinew::sqm {

struct PlaceOptions {
    bool ideal =
        true;  ///< false: joint points stay on the balls of their joints and rings are circles, as bridged
    bool limit = false;  ///< Fit::limit
};

/// Sets positions and origins of bridge.mesh. Fails only if the limit surface of the mesh cannot be found.
Result<void> place(const Parts& parts, const Images& images, const PlaceOptions& options, Bridge& bridge);

}  // namespace sinew::sqm
