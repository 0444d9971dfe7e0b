/// @file units.h
/// Names of units of length.
#pragma once

#include <optional>
#include <string_view>

namespace sinew {

/// Metres in one of the unit: "m", "mm", "um", "nm", "cm", "dm", "km", "in", "ft" and what else these are
/// called. Nothing for a name that is unknown or empty.
std::optional<double> metres_in(std::string_view unit);

}  // namespace sinew
