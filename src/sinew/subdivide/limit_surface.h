/// @file limit_surface.h
/// Where the vertices of the finest level go in the limit, and the normals there.
#pragma once

#include "sinew/subdivide/finest.h"

namespace sinew {

/// @param control  positions of the finest level; changed on the way, restored at the end
/// @param limit    as many
void find_limit_positions(const Finest& finest, std::span<Vec3f> control, std::span<Vec3f> limit);

/// @param control  positions of the finest level
/// @param mesh     the finest mesh; only its faces are read
/// @return unit normals, one for each corner of the mesh; zero where a vertex and its neighbours coincide
std::vector<Vec3f> find_limit_normals(const Finest& finest, std::span<const Vec3f> control,
                                      const QuadMesh& mesh);

}  // namespace sinew
