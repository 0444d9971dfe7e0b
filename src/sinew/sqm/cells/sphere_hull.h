/// @file sphere_hull.h
/// Convex hull of points on the unit sphere.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sinew/base/vec.h"

namespace sinew::sqm {

/// Faces counter-clockwise seen from outside: face f has the points corner[first[f]] .. corner[first[f + 1] -
/// 1]. Triangles, or, for points in one plane, two opposite polygons. Also working memory: reuse it.
struct SphereHull {
    std::vector<std::int32_t> first;
    std::vector<std::int32_t> corner;
    std::vector<std::int32_t>
        face_of;  ///< n * n: the face with the edge i -> j, at i n + j; -1 where there is none
    std::vector<Eigen::Matrix<std::int64_t, 3, 1>> grid;  ///< the points, rounded
    std::vector<std::array<std::int32_t, 3>> triangles, seen;

    std::int32_t face_count() const { return static_cast<std::int32_t>(first.size()) - 1; }
    std::span<const std::int32_t> face(std::int32_t f) const {
        return {corner.data() + first[f], corner.data() + first[f + 1]};
    }
};

/// @param points  at least three unit vectors, no two closer than 1e-4
/// Incremental, quadratic in the number of points, which is the degree of a joint. The sign of every
/// determinant is exact; points in the plane of a face count as not above it.
void find_sphere_hull(std::span<const Vec3> points, SphereHull& hull);

}  // namespace sinew::sqm
