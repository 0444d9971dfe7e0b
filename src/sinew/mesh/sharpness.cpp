#include "sinew/mesh/sharpness.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace sinew {
namespace {

using Index = std::uint32_t;

Result<void> append_creases(const QuadMesh& mesh, const Topology& topology, std::vector<SharpEdge>& edges) {
    for (const Crease& crease : mesh.features.creases) {
        if (!(crease.sharpness > 0)) continue;
        const Index edge = find_edge(topology, crease.edge);
        if (edge == no_index)
            return fail(ErrorKind::input,
                        fmt::format("the crease between vertices {} and {} is no edge of the mesh",
                                    crease.edge[0], crease.edge[1]));
        edges.push_back({edge, crease.sharpness, true});
    }
    return {};
}

void append_open_edges(const Topology& topology, std::vector<SharpEdge>& edges) {
    for (Index edge = 0; edge < topology.edge_count(); ++edge)
        if (topology.twin[topology.half_edges(edge)[0]] == no_index)
            edges.push_back({edge, infinite_sharpness, false});
}

/// Sorts by edge and keeps the sharpest of each, a listed one before one that is not.
void merge(std::vector<SharpEdge>& edges) {
    std::sort(edges.begin(), edges.end(), [](const SharpEdge& a, const SharpEdge& b) {
        return std::tuple(a.edge, -a.sharpness, !a.listed) < std::tuple(b.edge, -b.sharpness, !b.listed);
    });
    const auto same = [](const SharpEdge& a, const SharpEdge& b) { return a.edge == b.edge; };
    edges.erase(std::unique(edges.begin(), edges.end(), same), edges.end());
}

/// Are the faces of a vertex anything but one fan?
bool is_torn(const QuadMesh& mesh, const Topology& topology, Index vertex) {
    const auto ring = topology.ring(vertex);
    for (std::size_t i = 1; i < ring.size(); ++i)
        if (counter_clockwise(mesh, topology, ring[i - 1]) != ring[i]) return true;
    return false;
}

bool is_boundary_tip(const Topology& topology, Index vertex) {
    const auto ring = topology.ring(vertex);
    return ring.size() == 1 && topology.twin[ring[0]] == no_index;
}

Result<std::vector<Index>> find_corners(const QuadMesh& mesh, const Topology& topology) {
    std::vector<Index> corners;
    for (const Index vertex : mesh.features.corners) {
        if (vertex >= mesh.vertex_count())
            return fail(ErrorKind::input, fmt::format("the corner {} is no vertex of the mesh", vertex));
        corners.push_back(vertex);
    }
    for (Index vertex = 0; vertex < mesh.vertex_count(); ++vertex)
        if (is_boundary_tip(topology, vertex) || is_torn(mesh, topology, vertex)) corners.push_back(vertex);
    std::sort(corners.begin(), corners.end());
    return corners;
}

struct OwnedSpoke {
    Index vertex;
    SharpSpoke spoke;
};

std::vector<OwnedSpoke> both_ends(const Topology& topology, std::span<const SharpEdge> edges) {
    std::vector<OwnedSpoke> spokes;
    spokes.reserve(2 * edges.size());
    for (const auto& [edge, sharpness, listed] : edges) {
        const auto [a, b] = topology.edges[edge];
        spokes.push_back({a, {edge, b, sharpness}});
        spokes.push_back({b, {edge, a, sharpness}});
    }
    std::sort(spokes.begin(), spokes.end(), [](const OwnedSpoke& a, const OwnedSpoke& b) {
        return a.vertex != b.vertex ? a.vertex < b.vertex : a.spoke.end < b.spoke.end;
    });
    return spokes;
}

}  // namespace

Result<Sharpness> resolve_sharpness(const QuadMesh& mesh, const Topology& topology) {
    Sharpness result;
    if (auto done = append_creases(mesh, topology, result.edges); !done) return fail(done.error());
    append_open_edges(topology, result.edges);
    merge(result.edges);
    auto corners = find_corners(mesh, topology);
    if (!corners) return fail(corners.error());

    const std::vector<OwnedSpoke> spokes = both_ends(topology, result.edges);
    for (std::size_t s = 0, c = 0; s < spokes.size() || c < corners->size();) {
        const Index of_spoke = s < spokes.size() ? spokes[s].vertex : no_index;
        const Index of_corner = c < corners->size() ? (*corners)[c] : no_index;
        const Index vertex = std::min(of_spoke, of_corner);
        result.vertices.push_back(vertex);
        result.corner.push_back(of_corner == vertex);
        for (; s < spokes.size() && spokes[s].vertex == vertex; ++s) result.spokes.push_back(spokes[s].spoke);
        while (c < corners->size() && (*corners)[c] == vertex) ++c;
        result.first.push_back(static_cast<Index>(result.spokes.size()));
    }
    return result;
}

std::uint32_t find_sharp_vertex(const Sharpness& sharpness, std::uint32_t vertex) {
    const auto found = std::lower_bound(sharpness.vertices.begin(), sharpness.vertices.end(), vertex);
    if (found == sharpness.vertices.end() || *found != vertex) return no_index;
    return static_cast<Index>(found - sharpness.vertices.begin());
}

VertexRule vertex_rule(std::span<const SharpSpoke> spokes, bool corner) {
    VertexRule rule;
    double* const kinds[] = {&rule.smooth, &rule.smooth, &rule.crease,
                             &rule.corner};  // by the number of sharp edges
    std::size_t finer = 0, ends = 0;
    double fading = 0;
    for (std::size_t i = 0; i < spokes.size(); ++i) {
        const bool stays = finer_sharpness(spokes[i].sharpness) > 0;
        finer += stays;
        if (!stays) fading += spokes[i].sharpness;
        if ((stays || spokes.size() == 2) && ends < 2) rule.ends[ends++] = static_cast<Index>(i);
    }
    double* const now = corner ? &rule.corner : kinds[std::min<std::size_t>(spokes.size(), 3)];
    double* const next = corner ? &rule.corner : kinds[std::min<std::size_t>(finer, 3)];
    const double share = now == next ? 1 : std::min(1.0, fading / static_cast<double>(spokes.size() - finer));
    rule.smooth = 0;
    *now += share;
    *next += 1 - share;
    return rule;
}

}  // namespace sinew
