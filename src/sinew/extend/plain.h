/// @file plain.h
/// What the mesher takes: a graph of balls and bones in flat arrays, and what must be true of the mesh.
///
/// Invariants, which extend() establishes and the stages of sqm rely on: bones join two different nodes, no
/// two bones join the same two nodes, positions are finite, radii are positive and finite.
#pragma once

#include <cstdint>
#include <vector>

#include "sinew/base/vec.h"
#include "sinew/skeleton/graph.h"

namespace sinew {

/// How a tube ends at a leaf.
enum class Cap : std::uint8_t {
    round,  ///< half a ball beyond the node
    point,  ///< a cone: straight to its tip, which is the node's position
};

/// A rotation or reflection about the origin that maps the skeleton onto itself, bit for bit in the positions
/// that nodes were drawn at.
struct Automorphism {
    Mat3 generator = Mat3::Identity();
    std::int32_t order = 1;           ///< generator^order is the identity; 1: no symmetry
    std::vector<std::int32_t> image;  ///< node -> its image under the generator; empty without symmetry
};

struct Plain {
    std::vector<Vec3> position;
    std::vector<double> radius;
    std::vector<Bone> bones;
    std::vector<Cap> cap;  ///< one a node; means something at leaves only

    std::vector<std::int32_t>
        source_node;  ///< index of each node in the document; -1 for one that was made up
    std::vector<std::int32_t> source_bone;  ///< index of each bone in bones_of(document); -1 likewise

    Automorphism symmetry;

    std::int32_t node_count() const { return static_cast<std::int32_t>(position.size()); }
};

}  // namespace sinew
