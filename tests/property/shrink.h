/// @file shrink.h
/// Makes a failing case small.
#pragma once

#include <functional>

#include "property/random_skeletons.h"

namespace sinew::property {

/// The smallest case found of which `fails` is still true: takes away nodes and bones, options, types, and
/// digits, as long as any of that helps. `fails` must be true of the case given.
Case shrink(Case failing, const std::function<bool(const Case&)>& fails);

}  // namespace sinew::property
