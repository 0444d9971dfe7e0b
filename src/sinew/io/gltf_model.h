/// @file gltf_model.h
/// glTF 2.0 files as tinygltf reads them, with every number of an accessor checked.
#pragma once

#include <tiny_gltf.h>

#include <string>
#include <string_view>
#include <vector>

#include "sinew/base/result.h"
#include "sinew/base/vec.h"

namespace sinew {

/// Reads a .glb or a .gltf (the bytes tell which). Buffers in files of their own are read by the rule of
/// named_files.h, largest_input bytes of them at most; images are passed over and never opened. Nothing that refers to something else by an index
/// has been checked.
Result<tinygltf::Model> load_gltf(std::string_view bytes, const std::string& name);

/// The numbers of an accessor, `components` an item, with normalised integers as fractions and sparse values
/// in place. Fails where the accessor does not exist, has another number of components, or leads out of its
/// buffer.
Result<std::vector<double>> read_accessor(const tinygltf::Model& model, int accessor, int components,
                                          const std::string& name);

/// The nodes of the default scene (of all, where no scene is named: those without a parent) and all below
/// them, each with the way from it to glTF's world, parents before children. Fails for indices that lead
/// nowhere and for what is no tree (gltf_nodes.h).
struct PlacedNode {
    int node = 0;
    Eigen::Affine3d to_world;
};
Result<std::vector<PlacedNode>> place_nodes(const tinygltf::Model& model, const std::string& name);

}  // namespace sinew
