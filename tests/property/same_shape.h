/// @file same_shape.h
/// Are two meshes the same surface, however their vertices and faces are numbered?
#pragma once

#include <string>

#include "sinew/mesh/quad_mesh.h"

namespace sinew::property {

Mat3 mirror_of(int axis);

/// The image under a rotation or a reflection; faces are turned round so that they look outwards again.
QuadMesh moved(const QuadMesh& mesh, const Mat3& by);

/// Empty if the meshes have the same faces between the same places, else what differs. Vertices no further
/// apart than `tolerance`, as a share of the model's size, are the same place.
std::string difference_of(const QuadMesh& a, const QuadMesh& b, double tolerance);

}  // namespace sinew::property
