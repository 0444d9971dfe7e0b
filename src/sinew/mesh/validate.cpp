#include "sinew/mesh/validate.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <numeric>

namespace sinew {
namespace {

using Index = std::uint32_t;

/// Collects the faults among `count` places in their order: test(i, faults) adds place i where it is faulty.
template <class Found, class Test>
Found collect(std::size_t count, const Test& test) {
    using Range = tbb::blocked_range<std::size_t>;
    return tbb::parallel_reduce(
        Range(0, count, 8192), Found{},
        [&](const Range& range, Found found) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) test(i, found);
            return found;
        },
        [](Found left, const Found& right) {
            left.append(right);
            return left;
        });
}

struct FaceFaults {
    IndexFaults small, repeating;
    void append(const FaceFaults& later) {
        small.append(later.small);
        repeating.append(later.repeating);
    }
};

bool repeats_sorted(std::span<const Index> face) {
    std::vector<Index> vertices(face.size());
    std::copy(face.begin(), face.end(), vertices.begin());
    std::sort(vertices.begin(), vertices.end());
    return std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end();
}

bool repeats(std::span<const Index> face) {
    if (face.size() > 8) return repeats_sorted(face);
    for (std::size_t i = 1; i < face.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (face[i] == face[j]) return true;
    return false;
}

void find_bad_faces(const QuadMesh& mesh, Validation& result) {
    FaceFaults found = collect<FaceFaults>(mesh.face_count(), [&](std::size_t f, FaceFaults& faults) {
        if (mesh.face(f).size() < 3) faults.small.add(static_cast<Index>(f));
        if (repeats(mesh.face(f))) faults.repeating.add(static_cast<Index>(f));
    });
    result.small_faces = std::move(found.small);
    result.repeating_faces = std::move(found.repeating);
}

struct BadEdges {
    EdgeFaults boundary, nonmanifold, flipped;
    void append(const BadEdges& later) {
        boundary.append(later.boundary);
        nonmanifold.append(later.nonmanifold);
        flipped.append(later.flipped);
    }
};

void find_bad_edges(const Topology& topology, Validation& result) {
    BadEdges found = collect<BadEdges>(topology.edge_count(), [&](std::size_t e, BadEdges& faults) {
        const std::span<const Index> half_edges = topology.half_edges(e);
        if (half_edges.size() == 1) faults.boundary.add(topology.edges[e]);
        if (half_edges.size() > 2) faults.nonmanifold.add(topology.edges[e]);
        if (half_edges.size() == 2 && topology.twin[half_edges[0]] == no_index)
            faults.flipped.add(topology.edges[e]);
    });
    result.boundary_edges = std::move(found.boundary);
    result.nonmanifold_edges = std::move(found.nonmanifold);
    result.flipped_edges = std::move(found.flipped);
}

/// Do the twins alone show that the faces of a vertex are one fan? Walking its ring never leaves it early
/// then.
bool is_one_fan(const QuadMesh& mesh, const Topology& topology, std::span<const Index> ring) {
    for (std::size_t i = 0; i + 1 < ring.size(); ++i)
        if (counter_clockwise(mesh, topology, ring[i]) != ring[i + 1]) return false;
    return true;
}

/// The same where faces are oriented badly or meet by threes: faces hang together over any edge they share.
bool hangs_together(const QuadMesh& mesh, const Topology& topology, std::span<const Index> ring) {
    std::vector<std::pair<Index, Index>> sides;  // edge at the vertex, face (as its place in the ring)
    for (std::size_t i = 0; i < ring.size(); ++i)
        for (const Index h : {ring[i], previous_half_edge(mesh, topology, ring[i])})
            sides.emplace_back(topology.half_edge_edge[h], static_cast<Index>(i));
    std::sort(sides.begin(), sides.end());
    std::vector<Index> parent(ring.size());
    std::iota(parent.begin(), parent.end(), 0u);
    auto root = [&](Index i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    std::size_t fans = ring.size();
    for (std::size_t i = 1; i < sides.size(); ++i) {
        if (sides[i].first != sides[i - 1].first) continue;
        const Index a = root(sides[i - 1].second), b = root(sides[i].second);
        if (a != b) --fans;
        parent[a] = b;
    }
    return fans <= 1;
}

struct BadVertices {
    IndexFaults loose, nonmanifold;
    void append(const BadVertices& later) {
        loose.append(later.loose);
        nonmanifold.append(later.nonmanifold);
    }
};

void find_bad_vertices(const QuadMesh& mesh, const Topology& topology, Validation& result) {
    BadVertices found = collect<BadVertices>(mesh.vertex_count(), [&](std::size_t v, BadVertices& faults) {
        const std::span<const Index> ring = topology.ring(v);
        if (ring.empty()) faults.loose.add(static_cast<Index>(v));
        if (!is_one_fan(mesh, topology, ring) && !hangs_together(mesh, topology, ring))
            faults.nonmanifold.add(static_cast<Index>(v));
    });
    result.loose_vertices = std::move(found.loose);
    result.nonmanifold_vertices = std::move(found.nonmanifold);
}

/// Six times the volume between a face and the point `origin`.
double wedge(const QuadMesh& mesh, std::span<const Index> face, const Vec3& origin) {
    double sum = 0;
    auto corner = [&](std::size_t i) -> Vec3 { return mesh.positions[face[i]].cast<double>() - origin; };
    for (std::size_t i = 2; i < face.size(); ++i) sum += corner(0).dot(corner(i - 1).cross(corner(i)));
    return sum;
}

void find_components(const QuadMesh& mesh, const Topology& topology, Validation& result) {
    const std::vector<Index> component = component_of_vertices(topology);
    std::vector<double> volume(mesh.vertex_count(), 0);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        if (mesh.face(f).empty()) continue;
        const Index lowest = component[mesh.face(f)[0]];
        volume[lowest] += wedge(mesh, mesh.face(f), mesh.positions[lowest].cast<double>());
    }
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        if (component[v] != v || topology.ring(v).empty()) continue;
        ++result.components;
        if (volume[v] < 0) result.inward_components.add(static_cast<Index>(v));
    }
}

void look_at_arrays(const QuadMesh& mesh, Validation& result) {
    const std::vector<Index>& offsets = mesh.face_offsets;
    result.vertices = std::ssize(mesh.positions);
    result.faces = std::max<std::int64_t>(std::ssize(offsets) - 1, 0);
    result.sound_offsets = !offsets.empty() && offsets.front() == 0 &&
                           offsets.back() == mesh.corners.size() &&
                           std::is_sorted(offsets.begin(), offsets.end());
    result.bad_corners = collect<IndexFaults>(mesh.corners.size(), [&](std::size_t h, IndexFaults& faults) {
        if (mesh.corners[h] >= mesh.vertex_count()) faults.add(static_cast<Index>(h));
    });
    result.non_finite = collect<IndexFaults>(mesh.vertex_count(), [&](std::size_t v, IndexFaults& faults) {
        if (!mesh.positions[v].allFinite()) faults.add(static_cast<Index>(v));
    });
}

void look_at_surface(const QuadMesh& mesh, const Topology& topology, Validation& result) {
    result.edges = std::ssize(topology.edges);
    find_bad_faces(mesh, result);
    find_bad_edges(topology, result);
    find_bad_vertices(mesh, topology, result);
    find_components(mesh, topology, result);
    result.euler = result.vertices - result.loose_vertices.count - result.edges + result.faces;
}

}  // namespace

std::vector<std::uint32_t> component_of_vertices(const Topology& topology) {
    std::vector<Index> parent(topology.vertex_first.size() - 1);
    std::iota(parent.begin(), parent.end(), 0u);
    auto root = [&](Index i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    for (const MeshEdge& edge : topology.edges) {
        const Index a = root(edge[0]), b = root(edge[1]);
        parent[std::max(a, b)] = std::min(a, b);
    }
    // A parent is never above its child, so that one pass in ascending order finds every root.
    for (std::size_t v = 0; v < parent.size(); ++v) parent[v] = parent[parent[v]];
    return parent;
}

Validation validate(const QuadMesh& mesh) {
    if (well_formed(mesh)) return validate(mesh, build_topology(mesh));
    Validation result;
    look_at_arrays(mesh, result);
    return result;
}

Validation validate(const QuadMesh& mesh, const Topology& topology) {
    Validation result;
    look_at_arrays(mesh, result);
    look_at_surface(mesh, topology, result);
    return result;
}

}  // namespace sinew
