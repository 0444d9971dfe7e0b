/// @file normals.h
/// Normals to light a mesh with.
#pragma once

#include <vector>

#include "sinew/mesh/quad_mesh.h"

namespace sinew {

/// One unit normal a face, outward; zero for a face without an area.
std::vector<Vec3f> face_normals(const QuadMesh& mesh);

/// One unit normal a face corner: the mean over the faces round its vertex, weighted as in N. Max, "Weights
/// for computing vertex normals from facet normals" (1999), which is exact on spheres. Creases of sharpness 1
/// and above part the faces. Where there is no normal to be had it is the face's. Linear time.
std::vector<Vec3f> corner_normals(const QuadMesh& mesh, const std::vector<Vec3f>& face_normals);

}  // namespace sinew
