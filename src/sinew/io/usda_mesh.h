/// @file usda_mesh.h
/// A Mesh prim as USD has it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sinew/mesh/quad_mesh.h"

namespace sinew {

struct UsdaMesh {
    std::vector<float> points;  ///< three numbers each
    std::vector<std::int64_t> counts, indices;
    std::vector<std::int64_t> crease_indices, crease_lengths;
    std::vector<float> crease_sharpnesses;  ///< one a crease, or one an edge
    std::vector<std::int64_t> corner_indices;
    std::vector<float> corner_sharpnesses;
    bool left_handed = false;
};

/// Appends it to a mesh, its vertices behind those that are there. Returns what is wrong with it, if anything
/// is.
std::optional<std::string> append_usda_mesh(const UsdaMesh& usda, QuadMesh& mesh);

}  // namespace sinew
