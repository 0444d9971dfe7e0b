/// @file sinew_words.h
/// The words of the native format. For the sources of this folder only.
#pragma once

#include <array>
#include <string_view>

namespace sinew {

/// In the order of NodeType, Section and the axes.
inline constexpr std::array<std::string_view, 6> node_type_words{"sphere", "cone",     "hemisphere",
                                                                 "cube",   "negative", "ball"};
inline constexpr std::array<std::string_view, 2> section_words{"round", "rectangular"};
inline constexpr std::array<std::string_view, 3> axis_words{"x", "y", "z"};

}  // namespace sinew
