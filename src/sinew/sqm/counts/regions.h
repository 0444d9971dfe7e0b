/// @file regions.h
/// Which paths must have the same number of vertices round them: those of one component that lie on its
/// cycles or between them.
///
/// In: the network. Out: the component of every joint, and the paths of the 2-core (what is left when joints
/// that hang on by one path are taken away again and again). Linear; cannot fail.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "sinew/sqm/network.h"

namespace sinew::sqm {

struct Regions {
    std::vector<std::int32_t> component;  ///< joint -> component
    std::int32_t components = 0;
    std::vector<std::uint8_t>
        core;  ///< path -> both its ends are joints, and it is not in a tree hanging off

    /// The component of a path; -1 for one without joints.
    std::int32_t component_of(const Network& network, std::int32_t path) const {
        const auto& end = network.path_end[path];
        const std::int32_t joint = std::max(end[0].joint, end[1].joint);
        return joint < 0 ? -1 : component[joint];
    }
};

Regions find_regions(const Network& network);

}  // namespace sinew::sqm
