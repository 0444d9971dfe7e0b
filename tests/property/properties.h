/// @file properties.h
/// What is true of every skin (section 8 of the design), as one function.
#pragma once

#include <string>

#include "property/random_skeletons.h"

namespace sinew::property {

/// Empty if everything holds of a case; otherwise the name of the first property that does not, a colon, and
/// in what it fails.
std::string failure_of(const Case& tried);

/// The part before the colon.
std::string name_of(const std::string& failure);

}  // namespace sinew::property
