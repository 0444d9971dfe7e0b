#include "sinew/mesh/split.h"

#include "sinew/mesh/topology.h"

namespace sinew {
namespace {

using Index = std::uint32_t;

std::vector<char> sharp_edges(const Topology& topology, const Features& features) {
    std::vector<char> sharp(topology.edge_count(), 0);
    for (const Crease& crease : features.creases) {
        const Index edge = find_edge(topology, crease.edge);
        if (edge != no_index && crease.sharpness >= 1) sharp[edge] = 1;
    }
    return sharp;
}

/// Gives the sectors between the sharp edges of one vertex copies of their own, all but the first.
class Splitter {
  public:
    Splitter(const QuadMesh& mesh, const Topology& topology, const std::vector<char>& sharp, QuadMesh& result)
        : mesh_(mesh), topology_(topology), sharp_(sharp), result_(result) {}

    void operator()(Index vertex) {
        const std::span<const Index> ring = topology_.ring(vertex);
        const std::size_t n = ring.size();
        std::size_t start = 0;
        while (start < n && !starts_sector(ring, start)) ++start;
        Index copy = vertex;
        for (std::size_t i = 1; start < n && i < n; ++i) {
            const std::size_t at = (start + i) % n;
            if (starts_sector(ring, at)) {
                copy = static_cast<Index>(result_.positions.size());
                result_.positions.push_back(mesh_.positions[vertex]);
            }
            result_.corners[ring[at]] = copy;
        }
    }

  private:
    /// Is the edge between this face and the one before it, clockwise, sharp (or is there none)?
    bool starts_sector(std::span<const Index> ring, std::size_t at) const {
        const Index before = ring[at == 0 ? ring.size() - 1 : at - 1];
        return counter_clockwise(mesh_, topology_, before) != ring[at] ||
               sharp_[topology_.half_edge_edge[ring[at]]];
    }

    const QuadMesh& mesh_;
    const Topology& topology_;
    const std::vector<char>& sharp_;
    QuadMesh& result_;
};

}  // namespace

QuadMesh split_at_creases(const QuadMesh& mesh) {
    QuadMesh result;
    result.positions = mesh.positions;
    result.face_offsets = mesh.face_offsets;
    result.corners = mesh.corners;
    const Topology topology = build_topology(mesh);
    const std::vector<char> sharp = sharp_edges(topology, mesh.features);
    std::vector<char> touched(mesh.vertex_count(), 0);
    for (std::size_t e = 0; e < sharp.size(); ++e)
        if (sharp[e]) touched[topology.edges[e][0]] = touched[topology.edges[e][1]] = 1;
    Splitter split(mesh, topology, sharp, result);
    for (std::size_t v = 0; v < touched.size(); ++v)
        if (touched[v]) split(static_cast<Index>(v));
    return result;
}

}  // namespace sinew
