/// @file frames.h
/// The local frame of a node: how boxes, sections and ellipsoids are turned.
#pragma once

#include "sinew/skeleton/document.h"
#include "sinew/skeleton/graph.h"

namespace sinew {

/// The frame round the unit vector z, columns x, y, z: x is the world's X, or the world's Y where |z.X| >
/// 0.9, made orthogonal to z; y = z cross x; then `roll` degrees about z.
Mat3 frame_about(const Vec3& z, double roll = 0);

/// Whether a node's `rotation` means something: at a branch, at a lone node, and at a root that is a cube or
/// a ball. Elsewhere bones turn the node.
bool takes_rotation(const Node& node, std::int32_t degree);

/// What the frame of a node depends on beside the node. Unit vectors.
struct Surroundings {
    std::int32_t degree = 0;
    /// Along the bone from the parent to the node; at a root, from the node along its first bone.
    Vec3 first = Vec3::UnitZ();
    /// At a node of two bones, along the other one, in the same sense.
    Vec3 second = Vec3::UnitZ();
};

/// The frame of a node. It has the world's axes, or `rotation` where it is given, at a root that is a cube, a
/// ball, a branch or alone, and at a cube at a branch; anywhere at a branch where `rotation` is given.
/// Elsewhere z lies along the bone from the parent, or along the first bone of a root, which leads away from
/// it; at a connection along the bisector of both bones, onwards. A bone of no length counts as pointing
/// along the world's Z.
Mat3 local_frame(const Node& node, const Surroundings& around);

/// @param bones      bones_of(document)
/// @param neighbours adjacency of these bones
Mat3 local_frame(const Document& document, const std::vector<Bone>& bones, const Adjacency& neighbours,
                 std::int32_t node);

}  // namespace sinew
