#include "sinew/mesh/topology.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cassert>

namespace sinew {
namespace {

using Index = std::uint32_t;

/// A half-edge in the bucket of its lower vertex: the upper vertex in the high bits, so that sorting the keys
/// of a bucket brings the half-edges of each edge together, ascending.
using EdgeKey = std::uint64_t;
EdgeKey make_key(Index upper, Index half_edge) { return EdgeKey{upper} << 32 | half_edge; }
Index upper_of(EdgeKey key) { return static_cast<Index>(key >> 32); }
Index half_edge_of(EdgeKey key) { return static_cast<Index>(key); }

/// Vertices are worked on in blocks, whose number does not depend on the number of threads.
constexpr std::size_t block_size = 4096;

template <class Body>
void for_each_block(std::size_t count, const Body& body) {
    const std::size_t blocks = (count + block_size - 1) / block_size;
    tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
        body(block, block * block_size, std::min(count, (block + 1) * block_size));
    });
}

/// Calls body(half-edge, from, to) for every half-edge in ascending order.
template <class Body>
void for_each_half_edge(const QuadMesh& mesh, const Body& body) {
    const Index* corners = mesh.corners.data();
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const Index begin = mesh.face_offsets[f], end = mesh.face_offsets[f + 1];
        for (Index h = begin; h < end; ++h) body(h, corners[h], corners[h + 1 == end ? begin : h + 1]);
    }
}

/// Turns counts in [1..] into where each row starts, so that first[i + 1] is the place to fill row i from.
void start_rows(std::vector<Index>& first) {
    Index sum = 0;
    for (Index& entry : first) {
        const Index count = entry;
        entry = sum;
        sum += count;
    }
}

struct Buckets {
    std::vector<Index> first;   ///< vertices + 1 entries
    std::vector<EdgeKey> keys;  ///< half-edges by lower vertex
};

Buckets bucket_half_edges(const QuadMesh& mesh) {
    Buckets buckets;
    // One entry more than rows: filling moves each start to its end, which is the start of the next row.
    buckets.first.assign(mesh.vertex_count() + 2, 0);
    for_each_half_edge(mesh, [&](Index, Index a, Index b) { ++buckets.first[std::min(a, b) + 1]; });
    start_rows(buckets.first);
    buckets.keys.resize(mesh.corners.size());
    for_each_half_edge(mesh, [&](Index h, Index a, Index b) {
        buckets.keys[buckets.first[std::min(a, b) + 1]++] = make_key(std::max(a, b), h);
    });
    buckets.first.pop_back();
    return buckets;
}

void sort_keys(EdgeKey* begin, EdgeKey* end) {
    if (end - begin > 32) return std::sort(begin, end);
    for (EdgeKey* i = begin; i < end; ++i) {
        const EdgeKey key = *i;
        EdgeKey* j = i;
        for (; j > begin && j[-1] > key; --j) *j = j[-1];
        *j = key;
    }
}

/// Sorts the buckets and returns where the edges of each block of vertices start; the last entry counts them
/// all.
std::vector<Index> sort_buckets(Buckets& buckets) {
    const std::size_t vertices = buckets.first.size() - 1;
    std::vector<Index> block_first((vertices + block_size - 1) / block_size + 1, 0);
    for_each_block(vertices, [&](std::size_t block, std::size_t begin, std::size_t end) {
        Index edges = 0;
        for (std::size_t v = begin; v < end; ++v) {
            EdgeKey* const row = buckets.keys.data() + buckets.first[v];
            EdgeKey* const row_end = buckets.keys.data() + buckets.first[v + 1];
            sort_keys(row, row_end);
            for (EdgeKey* key = row; key < row_end; ++key)
                edges += key == row || upper_of(key[-1]) != upper_of(*key);
        }
        block_first[block] = edges;
    });
    start_rows(block_first);
    return block_first;
}

void pair_twins(const QuadMesh& mesh, std::span<const EdgeKey> keys, Topology& topology) {
    if (keys.size() != 2) return;
    const Index h = half_edge_of(keys[0]), g = half_edge_of(keys[1]);
    if (mesh.corners[h] == mesh.corners[g]) return;
    topology.twin[h] = g;
    topology.twin[g] = h;
}

void fill_edges_of_block(const QuadMesh& mesh, const Buckets& buckets, std::size_t begin, std::size_t end,
                         Index edge, Topology& topology) {
    for (std::size_t v = begin; v < end; ++v) {
        for (Index i = buckets.first[v]; i < buckets.first[v + 1]; ++edge) {
            const Index upper = upper_of(buckets.keys[i]);
            topology.edges[edge] = {static_cast<Index>(v), upper};
            topology.edge_first[edge] = i;
            const Index start = i;
            for (; i < buckets.first[v + 1] && upper_of(buckets.keys[i]) == upper; ++i) {
                topology.edge_half_edges[i] = half_edge_of(buckets.keys[i]);
                topology.half_edge_edge[half_edge_of(buckets.keys[i])] = edge;
            }
            pair_twins(mesh, std::span(buckets.keys).subspan(start, i - start), topology);
        }
    }
}

void build_edges(const QuadMesh& mesh, Topology& topology) {
    Buckets buckets = bucket_half_edges(mesh);
    const std::vector<Index> block_first = sort_buckets(buckets);
    const std::size_t half_edges = mesh.corners.size();
    topology.edges.resize(block_first.back());
    topology.edge_first.resize(topology.edges.size() + 1);
    topology.edge_first.back() = static_cast<Index>(half_edges);
    topology.edge_half_edges.resize(half_edges);
    topology.half_edge_edge.resize(half_edges);
    topology.twin.assign(half_edges, no_index);
    for_each_block(mesh.vertex_count(), [&](std::size_t block, std::size_t begin, std::size_t end) {
        fill_edges_of_block(mesh, buckets, begin, end, block_first[block], topology);
    });
}

void build_faces(const QuadMesh& mesh, Topology& topology) {
    topology.half_edge_face.resize(mesh.corners.size());
    for_each_block(mesh.face_count(), [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            std::fill(topology.half_edge_face.begin() + mesh.face_offsets[f],
                      topology.half_edge_face.begin() + mesh.face_offsets[f + 1], static_cast<Index>(f));
    });
}

void bucket_by_origin(const QuadMesh& mesh, Topology& topology) {
    topology.vertex_first.assign(mesh.vertex_count() + 2, 0);
    for (const Index v : mesh.corners) ++topology.vertex_first[v + 1];
    start_rows(topology.vertex_first);
    topology.vertex_half_edges.resize(mesh.corners.size());
    for (std::size_t h = 0; h < mesh.corners.size(); ++h)
        topology.vertex_half_edges[topology.vertex_first[mesh.corners[h] + 1]++] = static_cast<Index>(h);
    topology.vertex_first.pop_back();
}

/// Brings the half-edges of one vertex, which come ascending, into the order of its fans.
class RingSorter {
  public:
    RingSorter(const QuadMesh& mesh, const Topology& topology, std::vector<char>& placed)
        : mesh_(mesh), topology_(topology), placed_(placed) {}

    void operator()(std::span<Index> row) {
        unsorted_.assign(row.begin(), row.end());
        Index* out = row.data();
        for (const Index h : unsorted_)
            if (topology_.twin[h] == no_index) out = place_fan(h, out);
        for (const Index h : unsorted_)
            if (!placed_[h]) out = place_fan(h, out);
    }

  private:
    Index* place_fan(Index h, Index* out) {
        for (; h != no_index && !placed_[h]; h = counter_clockwise(mesh_, topology_, h)) {
            placed_[h] = 1;
            *out++ = h;
        }
        return out;
    }

    const QuadMesh& mesh_;
    const Topology& topology_;
    std::vector<char>& placed_;  ///< each half-edge leaves one vertex: no two threads meet
    std::vector<Index> unsorted_;
};

void sort_rings(const QuadMesh& mesh, Topology& topology) {
    std::vector<char> placed(mesh.corners.size(), 0);
    for_each_block(mesh.vertex_count(), [&](std::size_t, std::size_t begin, std::size_t end) {
        RingSorter sort_ring(mesh, topology, placed);
        for (std::size_t v = begin; v < end; ++v)
            sort_ring({topology.vertex_half_edges.data() + topology.vertex_first[v],
                       topology.vertex_half_edges.data() + topology.vertex_first[v + 1]});
    });
}

}  // namespace

bool well_formed(const QuadMesh& mesh) {
    const std::vector<Index>& offsets = mesh.face_offsets;
    if (offsets.empty() || offsets.front() != 0 || offsets.back() != mesh.corners.size()) return false;
    if (!std::is_sorted(offsets.begin(), offsets.end())) return false;
    return std::all_of(mesh.corners.begin(), mesh.corners.end(),
                       [&](Index v) { return v < mesh.vertex_count(); });
}

Topology build_topology(const QuadMesh& mesh) {
    assert(well_formed(mesh) && mesh.corners.size() < no_index);
    Topology topology;
    tbb::parallel_invoke([&] { build_edges(mesh, topology); },
                         [&] {
                             build_faces(mesh, topology);
                             bucket_by_origin(mesh, topology);
                         });
    sort_rings(mesh, topology);
    return topology;
}

std::uint32_t find_edge(const Topology& topology, MeshEdge edge) {
    if (edge[0] > edge[1]) std::swap(edge[0], edge[1]);
    const auto found = std::lower_bound(topology.edges.begin(), topology.edges.end(), edge);
    if (found == topology.edges.end() || *found != edge) return no_index;
    return static_cast<Index>(found - topology.edges.begin());
}

std::vector<std::uint32_t> valences(const Topology& topology) {
    std::vector<Index> result(topology.vertex_first.size() - 1, 0);
    for (const MeshEdge& edge : topology.edges) {
        ++result[edge[0]];
        result[edge[1]] += edge[0] != edge[1];
    }
    return result;
}

}  // namespace sinew
