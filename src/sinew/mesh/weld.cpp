#include "sinew/mesh/weld.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <numeric>

#include "sinew/mesh/topology.h"

namespace sinew {
namespace {

using Index = std::uint32_t;

/// The first vertex at the position of each.
std::vector<Index> first_twins(const std::vector<Vec3f>& positions) {
    std::vector<Index> order(positions.size()), first(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    tbb::parallel_sort(order.begin(), order.end(), [&](Index a, Index b) {
        const Vec3f &p = positions[a], &q = positions[b];
        if (p.x() != q.x()) return p.x() < q.x();
        if (p.y() != q.y()) return p.y() < q.y();
        if (p.z() != q.z()) return p.z() < q.z();
        return a < b;
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool twin = i > 0 && positions[order[i]] == positions[order[i - 1]];
        first[order[i]] = twin ? first[order[i - 1]] : order[i];
    }
    return first;
}

/// Appends a face without the corners that repeat the one before them, if enough is left.
void append_face(const QuadMesh& mesh, std::size_t f, const std::vector<Index>& first, QuadMesh& result) {
    const std::size_t start = result.corners.size();
    for (const Index v : mesh.face(f))
        if (result.corners.size() == start || result.corners.back() != first[v])
            result.corners.push_back(first[v]);
    while (result.corners.size() > start + 1 && result.corners.back() == result.corners[start])
        result.corners.pop_back();
    if (result.corners.size() < start + 3) return result.corners.resize(start);
    result.face_offsets.push_back(static_cast<Index>(result.corners.size()));
}

}  // namespace

QuadMesh welded(const QuadMesh& mesh) {
    const std::vector<Index> first = first_twins(mesh.positions);
    QuadMesh result;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) append_face(mesh, f, first, result);
    std::vector<Index> place(mesh.vertex_count(), no_index);
    for (const Index v : result.corners) place[v] = 0;
    for (std::size_t v = 0; v < place.size(); ++v) {
        if (place[v] == no_index) continue;
        place[v] = static_cast<Index>(result.positions.size());
        result.positions.push_back(mesh.positions[v]);
    }
    for (Index& v : result.corners) v = place[v];
    return result;
}

}  // namespace sinew
