/// @file frames.h
/// The local frame of a node: how boxes, sections and ellipsoids are turned.
#pragma once

#include "sinew/skeleton/document.h"
#include "sinew/skeleton/graph.h"

namespace sinew {

/// The frame round the unit vector z, columns x, y, z: x is the world's X, or the world's Y where |z.X| >
/// 0.9, made orthogonal to z; y = z cross x; then `roll` degrees about z.
Mat3 frame_about(const Vec3& z, double roll = 0);

/// The frame of a node. z lies along the bone from the parent; at a connection along the bisector of its two
/// bones, onwards; a root and a cube at a branch have the world's axes, or `rotation` where it is given (a
/// root, a cube or a ball). A bone of no length counts as pointing along the world's Z.
/// @param bones      bones_of(document)
/// @param neighbours adjacency of these bones
Mat3 local_frame(const Document& document, const std::vector<Bone>& bones, const Adjacency& neighbours,
                 std::int32_t node);

}  // namespace sinew
