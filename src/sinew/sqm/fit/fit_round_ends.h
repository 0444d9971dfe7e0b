/// @file fit_round_ends.h
/// The round ends of a path, where their control points belong.
#pragma once

#include <array>
#include <span>

#include "sinew/sqm/bridge/bridge.h"

namespace sinew::sqm {

/// Moves the poles and rings of a path's round ends from the ideal surface to control points whose smooth
/// surface is there (round_end.h), both ends together where they meet.
/// @param held    what widens a ring so that its smooth curve has the radius
/// @param points  by vertex, in and out: only those of the ends change
/// @return whether the path's start and its end are such ends
std::array<bool, 2> fit_round_ends(const Parts& parts, const Bridge& bridge, std::int32_t path, double held,
                                   std::span<Vec3> points);

}  // namespace sinew::sqm
