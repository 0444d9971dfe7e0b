/// @file hostile_skeletons.h
/// Skeletons that nobody would draw and anybody may send, from a seed.
#pragma once

#include <cstdint>

#include "property/random_skeletons.h"

namespace sinew::property {

/// Dense graphs, radii of neighbours that differ by powers of ten, directions that hardly differ, nodes
/// inside other nodes or on one line, every type, size and section at any node, and symmetries of up to forty
/// images, all mixed. Whatever validate() accepts of it must come out closed, manifold and outward.
Case hostile_case(std::uint64_t seed);

}  // namespace sinew::property
