/// @file topology.h
/// Who is whose neighbour in a polygon mesh: edges, half-edge twins and the ring round each vertex, in flat
/// arrays.
///
/// Half-edge h is the side of a face that starts at corner h: it runs from mesh.corners[h] to the face's next
/// corner, so that half-edges need no numbering of their own. Any mesh is fine, also an open or a broken one:
/// an edge has as many half-edges as there are, and only a sound pair of them are twins.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sinew/mesh/quad_mesh.h"

namespace sinew {

inline constexpr std::uint32_t no_index = 0xffffffffu;

struct Topology {
    std::vector<MeshEdge> edges;                 ///< the lower vertex first, in ascending order
    std::vector<std::uint32_t> edge_first;       ///< edges + 1 entries into edge_half_edges
    std::vector<std::uint32_t> edge_half_edges;  ///< half-edges edge after edge, ascending in each
    std::vector<std::uint32_t> half_edge_edge;   ///< edge of each half-edge
    std::vector<std::uint32_t> half_edge_face;   ///< face of each half-edge
    /// The half-edge on the other side; no_index where the edge does not have just two half-edges, of
    /// opposite direction.
    std::vector<std::uint32_t> twin;
    std::vector<std::uint32_t> vertex_first;  ///< vertices + 1 entries into vertex_half_edges
    /// Half-edges that leave each vertex, counter-clockwise seen from outside, fan after fan: open fans first
    /// (each from its clockwise end), then closed ones, each kind in the order of its lowest half-edge.
    std::vector<std::uint32_t> vertex_half_edges;

    std::size_t edge_count() const { return edges.size(); }
    std::span<const std::uint32_t> half_edges(std::size_t edge) const {
        return {edge_half_edges.data() + edge_first[edge], edge_half_edges.data() + edge_first[edge + 1]};
    }
    std::span<const std::uint32_t> ring(std::size_t vertex) const {
        return {vertex_half_edges.data() + vertex_first[vertex],
                vertex_half_edges.data() + vertex_first[vertex + 1]};
    }
};

/// Builds it by counting sorts, in time linear in the corners (times a logarithm at vertices of huge
/// valence). The mesh must be well formed (below) and have fewer than 2^32 - 1 corners. The same on any
/// number of threads.
Topology build_topology(const QuadMesh& mesh);

/// Are the offsets ascending from 0 to the number of corners, and do all corners name vertices?
bool well_formed(const QuadMesh& mesh);

/// The half-edge after and before h in its face.
inline std::uint32_t next_half_edge(const QuadMesh& mesh, const Topology& topology, std::uint32_t h) {
    const std::uint32_t face = topology.half_edge_face[h];
    return h + 1 == mesh.face_offsets[face + 1] ? mesh.face_offsets[face] : h + 1;
}
inline std::uint32_t previous_half_edge(const QuadMesh& mesh, const Topology& topology, std::uint32_t h) {
    const std::uint32_t face = topology.half_edge_face[h];
    return (h == mesh.face_offsets[face] ? mesh.face_offsets[face + 1] : h) - 1;
}

/// The next half-edge counter-clockwise round the vertex that h leaves; no_index at the end of an open fan.
inline std::uint32_t counter_clockwise(const QuadMesh& mesh, const Topology& topology, std::uint32_t h) {
    return topology.twin[previous_half_edge(mesh, topology, h)];
}

/// Index of the edge between two vertices, in any order; no_index where there is none. A binary search.
std::uint32_t find_edge(const Topology& topology, MeshEdge edge);

/// Number of edges at each vertex.
std::vector<std::uint32_t> valences(const Topology& topology);

}  // namespace sinew
