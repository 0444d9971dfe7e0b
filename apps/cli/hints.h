/// @file hints.h
/// "Did you mean ...?" for what the user mistyped.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sinew::cli {

/// The choice that is nearest to the word, by the number of letters to change; empty where none is near.
std::string nearest(std::string_view word, const std::vector<std::string>& choices);

}  // namespace sinew::cli
