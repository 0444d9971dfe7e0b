/// @file sharpness.h
/// Sharp edges and corners of a mesh as subdivision meets them: semi-sharp creases after DeRose, Kass and
/// Truong, "Subdivision surfaces in character animation" (SIGGRAPH 1998).
///
/// A boundary edge, and an edge that is not between two faces of like orientation, is infinitely sharp. A
/// vertex is a corner if the features say so, if it is on the boundary with a single face (OpenSubdiv's
/// VTX_BOUNDARY_EDGE_AND_CORNER, which is also USD's default), or if its faces are not one fan.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sinew/base/result.h"
#include "sinew/mesh/topology.h"

namespace sinew {

inline constexpr float infinite_sharpness = 10;  ///< from here on an edge stays sharp for ever

/// Sharpness of the two halves of an edge, one level finer: 1 less, but infinite stays as it is.
inline float finer_sharpness(float sharpness) {
    return sharpness >= infinite_sharpness ? sharpness : sharpness > 1 ? sharpness - 1 : 0;
}

struct SharpEdge {
    std::uint32_t edge = 0;
    float sharpness = 0;
    bool listed = false;  ///< by the features of the mesh; the others are sharp because the mesh ends there
};

/// A sharp edge seen from one of its vertices.
struct SharpSpoke {
    std::uint32_t edge = 0;
    std::uint32_t end = 0;  ///< its other vertex
    float sharpness = 0;
};

/// Sparse: only what is sharp.
struct Sharpness {
    std::vector<SharpEdge> edges;         ///< ascending by edge
    std::vector<std::uint32_t> vertices;  ///< ends of sharp edges, and corners
    std::vector<char> corner;             ///< for each of them: does it never move?
    std::vector<std::uint32_t> first{0};  ///< rows of `spokes`: vertices + 1 entries
    std::vector<SharpSpoke> spokes;

    std::span<const SharpSpoke> spokes_of(std::size_t i) const {
        return {spokes.data() + first[i], spokes.data() + first[i + 1]};
    }
};

/// Finds everything sharp about a well-formed mesh; `vertices` ascend. Where an edge is listed twice the
/// sharper one counts. Fails for a crease that is no edge of the mesh and for a corner that is no vertex.
Result<Sharpness> resolve_sharpness(const QuadMesh& mesh, const Topology& topology);

/// Place of a vertex in `vertices` where these ascend; no_index where it is not sharp.
std::uint32_t find_sharp_vertex(const Sharpness& sharpness, std::uint32_t vertex);

/// How a vertex moves in one step of subdivision: a blend (the shares sum to 1) of the smooth rule, of the
/// crease rule 3/4 v + 1/8 (ends) and of staying.
struct VertexRule {
    double smooth = 1;
    double crease = 0;
    double corner = 0;
    std::array<std::uint32_t, 2>
        ends{};  ///< of the crease: places in the list of spokes that was asked about
};
/// @param spokes  sharpness of the vertex's sharp edges, each above 0
VertexRule vertex_rule(std::span<const SharpSpoke> spokes, bool corner);

/// Share of the crease rule (the midpoint) in the new vertex of an edge.
inline float edge_rule(float sharpness) { return sharpness < 1 ? sharpness : 1; }

}  // namespace sinew
