/// @file swc_soma.h
/// Somata that stand for one sphere. For the sources of this folder only.
#pragma once

#include <cstdint>
#include <vector>

#include "sinew/base/vec.h"
#include "sinew/io/measured.h"

namespace sinew {

struct SwcSample {
    std::int64_t id = 0;
    std::int64_t type = 0;
    std::int64_t parent_id = -1;
    std::int64_t line = 0;
    std::int32_t parent = -1;  ///< index
    Vec3 position = Vec3::Zero();
    double radius = 0;
};

/// Folds somata into their root sample, where that is a sphere, and returns which samples are gone; children
/// of those become the root's. The parents must be a forest. Folded are, under a root of type 1 (soma):
///
/// - NeuroMorpho's three-point soma: exactly two further soma samples, both leaves of the soma, with the
/// root's
///   radius and opposite each other at that distance from it, to 1 %;
/// - a contour: a chain of at least three more soma samples that comes back to the root (the gap is at most
///   twice the longest step) round a centre that is further away than twice the largest radius and that no
///   sample is near. The root moves to the mean of the contour and takes the mean distance from there as its
///   radius.
std::vector<char> fold_somata(std::vector<SwcSample>& samples, Remarks& remarks);

}  // namespace sinew
