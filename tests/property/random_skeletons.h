/// @file random_skeletons.h
/// Skeletons of every awkward kind, from a seed: the same seed gives the same skeleton everywhere.
#pragma once

#include <cstdint>
#include <string>

#include "sinew/skeleton/document.h"
#include "sinew/sqm/skin.h"

namespace sinew::property {

/// What is tried: a skeleton and how to skin it.
struct Case {
    std::string kind;
    Document document;
    SkinOptions options;
};

Case random_case(std::uint64_t seed);

}  // namespace sinew::property
