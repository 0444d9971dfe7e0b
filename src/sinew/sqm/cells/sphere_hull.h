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
    struct Edge {
        std::int32_t to = 0, face = 0;
    };
    std::vector<std::int32_t> edge_first;  ///< point -> the first edge that leaves it; points + 1 entries
    std::vector<Edge> edges;               ///< those of each point in the order of where they go
    std::vector<Eigen::Matrix<std::int64_t, 3, 1>> grid;  ///< the points, rounded
    std::vector<std::array<std::int32_t, 3>> triangles, seen;
    std::vector<std::int32_t> stays, next;

    /// The face with an edge; -1 where there is none.
    std::int32_t face_of(std::int32_t from, std::int32_t to) const;
    std::int32_t face_count() const { return static_cast<std::int32_t>(first.size()) - 1; }
    std::span<const std::int32_t> face(std::int32_t f) const {
        return {corner.data() + first[f], corner.data() + first[f + 1]};
    }
};

/// @param points  at least three unit vectors, no two closer than 1e-4
/// Incremental, and quadratic in the number of points, which is the degree of a joint, up to a number of them
/// from which another way is taken that is near-linear (large_hull.h). The sign of every determinant is
/// exact; points in the plane of a face count as not above it.
void find_sphere_hull(std::span<const Vec3> points, SphereHull& hull);

}  // namespace sinew::sqm
