/// @file random_kinds.h
/// The kinds of skeletons that are hard to mesh, drawn at random: nothing but balls and bones, these as
/// links.
#pragma once

#include <string>

#include "property/random.h"
#include "sinew/skeleton/document.h"

namespace sinew::property {

/// Draws one of the kind that the seed falls on, and returns that kind's name.
std::string draw_random_kind(Random& random, std::uint64_t seed, Document& document);

}  // namespace sinew::property
