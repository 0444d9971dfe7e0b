/// @file triangle_pair.h
/// Do two triangles of a mesh meet where they should not? Exact.
#pragma once

#include "sinew/mesh/triangulate.h"

namespace sinew {

/// Do the triangles have a point in common beyond the vertices, and the edge between them, that they share by
/// index? Triangles that share nothing intersect where they touch, too. Neither may have its points on one
/// line (projection_axis() of predicates.h tells).
bool triangles_intersect(const std::vector<Vec3f>& positions, const Triangle& a, const Triangle& b);

}  // namespace sinew
