/// @file vec.h
/// Vectors. Geometry is computed in double precision; meshes store single precision.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace sinew {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;   ///< positions and directions while computing
using Vec3f = Eigen::Vector3f;  ///< positions in a mesh (12 bytes, tightly packed in a std::vector)
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

}  // namespace sinew
