/// @file images.h
/// What a symmetry of the skeleton does to its joints, cells, arcs and paths.
#pragma once

#include <cstdint>
#include <vector>

#include "sinew/sqm/cells/polyhedra.h"

namespace sinew::sqm {

/// Images under the generator of Plain::symmetry. Empty vectors where there is no symmetry, or where the
/// structure found at the joints does not follow it (then the mesh is made without it).
struct Images {
    std::int32_t order = 1;
    Mat3 generator = Mat3::Identity();
    bool reverses = false;  ///< a reflection: left and right, and the sense of rings, change places
    std::vector<std::int32_t> joint, cell, vertex, arc, path;
    std::vector<std::uint8_t>
        arc_reversed;  ///< the image of an arc runs from the image of its end to that of its beginning
    std::vector<std::uint8_t> path_reversed;

    bool any() const { return order > 1; }
};

Images find_images(const Plain& skeleton, const Network& network, const Polyhedra& polyhedra);

}  // namespace sinew::sqm
