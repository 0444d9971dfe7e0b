/// @file large_hull.h
/// Convex hull of very many points on the unit sphere, in near-linear time.
///
/// Points go in one by one as in sphere_hull.h, but in an order of a few random rounds, each along a curve
/// that fills space (N. Amenta, S. Choi, G. Rote, "Incremental constructions con BRIO", SoCG 2003), and the
/// faces that see a point are found from the nearest point that is in already: a walk from neighbour to
/// neighbour leads there, as the hull is the Delaunay triangulation.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sinew/base/vec.h"

namespace sinew::sqm {

/// @param points  unit vectors; `tetrahedron` names four of them that are not in one plane
/// @param grid    the points rounded to integers of at most 39 bits, by which signs are exact
/// @return triangles counter-clockwise seen from outside. Points inside the hull, as rounding may put those
///         that nearly coincide, are no corners.
std::vector<std::array<std::int32_t, 3>> find_large_hull(
    std::span<const Vec3> points, std::span<const Eigen::Matrix<std::int64_t, 3, 1>> grid,
    std::array<std::int32_t, 4> tetrahedron);

/// Positive if d is on the side from which a, b, c are counter-clockwise; exact for the same integers.
int wide_orientation(const Eigen::Matrix<std::int64_t, 3, 1>& a, const Eigen::Matrix<std::int64_t, 3, 1>& b,
                     const Eigen::Matrix<std::int64_t, 3, 1>& c, const Eigen::Matrix<std::int64_t, 3, 1>& d);

}  // namespace sinew::sqm
