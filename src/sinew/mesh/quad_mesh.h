/// @file quad_mesh.h
/// A polygon mesh in flat arrays, with what later stages must know about it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sinew/base/vec.h"

namespace sinew {

using MeshEdge = std::array<std::uint32_t, 2>;  ///< two vertices that share an edge, in any order

struct Crease {
    MeshEdge edge{};
    float sharpness = 0;  ///< > 0; 10 and above (also infinity) never smooths out
};

/// Edges that lie on a circle (rims of flat ends, where a tube meets a ball): subdivision keeps their
/// vertices on it.
struct Circle {
    Vec3f centre = Vec3f::Zero();
    Vec3f axis = Vec3f::UnitZ();  ///< unit normal of the circle's plane
    float radius = 1;
    std::vector<MeshEdge> edges;
};

/// Faces that lie in a plane (flat ends, sides of boxes): subdivision keeps their vertices in it.
struct Plane {
    Vec3f point = Vec3f::Zero();
    Vec3f normal = Vec3f::UnitZ();  ///< unit, outward
    std::vector<std::uint32_t> faces;
};

/// What must stay true of a mesh under subdivision. Sparse.
struct Features {
    std::vector<Crease> creases;
    std::vector<std::uint32_t> corners;  ///< vertices that never move (tips of cones, corners of boxes)
    std::vector<std::uint32_t> poles;    ///< the middle vertex of each triangle fan
    std::vector<Circle> circles;
    std::vector<Plane> planes;
};

/// Faces are counter-clockwise seen from outside. Face f has the vertices
/// corners[face_offsets[f]] .. corners[face_offsets[f + 1] - 1].
struct QuadMesh {
    std::vector<Vec3f> positions;
    std::vector<std::uint32_t> face_offsets{0};  ///< faces + 1 entries, the first 0
    std::vector<std::uint32_t> corners;          ///< vertex indices, face after face

    // Where a vertex came from: empty, or one entry a vertex.
    std::vector<std::int32_t>
        vertex_node;  ///< index of the nearest node in the skinned document's node array; -1 unknown
    std::vector<std::int32_t>
        vertex_bone;                  ///< index of the bone (see bones_of) of a tube's vertex; -1 at joints
    std::vector<float> vertex_along;  ///< parameter along that bone in [0, 1], 0 at the bone's first node

    Features features;

    std::size_t vertex_count() const { return positions.size(); }
    std::size_t face_count() const { return face_offsets.size() - 1; }
    std::span<const std::uint32_t> face(std::size_t f) const {
        return {corners.data() + face_offsets[f], corners.data() + face_offsets[f + 1]};
    }
    void add_face(std::span<const std::uint32_t> vertices) {
        corners.insert(corners.end(), vertices.begin(), vertices.end());
        face_offsets.push_back(static_cast<std::uint32_t>(corners.size()));
    }
};

}  // namespace sinew
