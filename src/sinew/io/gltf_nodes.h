/// @file gltf_nodes.h
/// The tree of nodes in a glTF 2.0 file, and where they are: what skeletons and meshes hang in. For the
/// sources of this folder only.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sinew/base/result.h"
#include "sinew/base/vec.h"

namespace sinew {

/// Nodes by their numbers in the file.
struct GltfTree {
    std::vector<std::vector<std::int32_t>> children;
    std::vector<Eigen::Affine3d> to_parent;
    std::vector<std::int32_t> parent;  ///< -1: none; written by find_parents
};

/// What a node's `translation`, `rotation` and `scale` do; a rotation of any length counts, and one of none
/// does nothing.
Eigen::Affine3d gltf_transform(const Vec3& translation, const Quat& rotation, const Vec3& scale);
/// What its `matrix` does, which glTF writes by columns.
Eigen::Affine3d gltf_transform(std::span<const double, 16> matrix);

/// Fails, with the JSON pointer, for children that do not exist, nodes with two parents, and those that are
/// their own ancestors.
Result<void> find_parents(GltfTree& tree);

/// The nodes without a parent.
std::vector<std::int32_t> roots_of(const GltfTree& tree);

/// Some nodes and all below them, each once, parents before their children.
std::vector<std::int32_t> parents_first(const GltfTree& tree, std::span<const std::int32_t> from);

/// From each node to glTF's world. The parents must have been found.
std::vector<Eigen::Affine3d> to_world(const GltfTree& tree);

/// glTF's y is up, ours z: turns a point or a direction of glTF's world into ours.
Eigen::Affine3d gltf_to_z_up();

}  // namespace sinew
