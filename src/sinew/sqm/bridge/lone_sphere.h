/// @file lone_sphere.h
/// The mesh of a node without bones: a cube of 3 x 3 x 3 points but its middle, made round (or left a box).
#pragma once

#include <array>
#include <cstdint>

namespace sinew::sqm {

/// Directions (not unit) of its 26 vertices, each coordinate -1, 0 or 1, the first one fastest.
const std::array<std::array<int, 3>, 26>& lone_sphere_points();

/// Its 24 quads, by index in those points, counter-clockwise seen from outside: side by side of the cube, -x
/// first, then +x, and so on, four a side.
const std::array<std::array<std::uint32_t, 4>, 24>& lone_sphere_faces();

}  // namespace sinew::sqm
