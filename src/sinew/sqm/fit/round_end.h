/// @file round_end.h
/// The control profile of a round end whose smooth surface is the ball and the cone below it.
///
/// A round end has few rings, and the pole, the rings and the tube below are one cubic B-spline along the
/// path (the polar rule of the subdivision makes it so). Asking its limit to pass through the rings makes it
/// swing out between them: by 16 % of the radius with one ring, so that a stick becomes an ellipsoid. So the
/// heights of the rings are let go as well, and all are found together, by least squares against the distance
/// to the ball and the cone and then to the worst of it. What is left is at most 3 % of the radius with one
/// ring, 1.6 % with two and 1 % with three, and half of that or less where the tube is not steep.
#pragma once

#include <span>

#include "sinew/base/vec.h"

namespace sinew::sqm {

/// Heights are along the outward axis from the centre of the ball, in its radii; so are the radii of rings.
struct ProfileRow {
    double height = 0, radius = 0;
};

inline constexpr std::size_t most_round_rings = 8;  ///< with more the rings themselves are near enough

/// @param sine   of the cone's slope below, above -1 and below 1: at this height it touches the ball
/// @param rows   in and out: the pole first, whose radius stays 0, then 1 to most_round_rings rings, the
///               highest first; on the way in on the ball
/// @param below  the next two rings down the path, whose control points are known
/// Rows that would not stand above one another (rings below that are no continuation of the end) are left as
/// they were.
void fit_round_end(double sine, std::span<ProfileRow> rows, const ProfileRow (&below)[2]);

}  // namespace sinew::sqm
