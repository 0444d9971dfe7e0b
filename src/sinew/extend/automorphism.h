/// @file automorphism.h
/// Symmetries of a skeleton as permutations of its nodes.
#pragma once

#include <cstdint>
#include <vector>

#include "sinew/base/vec.h"
#include "sinew/skeleton/graph.h"

namespace sinew {

/// A rotation or reflection about the origin that maps the skeleton onto itself.
struct Automorphism {
    Mat3 generator = Mat3::Identity();
    std::int32_t order = 1;           ///< generator^order is the identity; 1: no symmetry
    std::vector<std::int32_t> image;  ///< node -> its image under the generator; empty without symmetry
};

/// Whether the bones, taken to the images of their nodes, are the same bones.
bool bones_follow(std::vector<Bone> bones, const std::vector<std::int32_t>& image);

}  // namespace sinew
