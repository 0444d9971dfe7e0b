#include "sinew/render/normals.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sinew/mesh/normals.h"

namespace sinew {
namespace {

/// The zero vector stays one. Squares of what is very long or short would leave the range of a float.
Vec3f unit(const Vec3f& v) {
    const float square = v.squaredNorm();
    if (square > 1e-30f && square < 1e30f) return v / std::sqrt(square);
    const float length = v.stableNorm();
    return length > 0 && std::isfinite(length) ? Vec3f(v / length) : Vec3f::Zero();
}

/// Twice the area, along the normal; right for faces that are not planar too.
Vec3f area_vector(const QuadMesh& mesh, std::span<const std::uint32_t> face) {
    const auto at = [&](std::size_t i) -> const Vec3f& { return mesh.positions[face[i]]; };
    if (face.size() == 4) return (at(2) - at(0)).cross(at(3) - at(1));
    Vec3f sum = Vec3f::Zero();
    for (std::size_t i = 1; i + 1 < face.size(); ++i) sum += (at(i) - at(0)).cross(at(i + 1) - at(0));
    return sum;
}

/// What corner i of a face adds to the normal of its vertex.
Vec3f share_of(const QuadMesh& mesh, std::span<const std::uint32_t> face, std::size_t i) {
    const std::size_t before = i == 0 ? face.size() - 1 : i - 1, after = i + 1 == face.size() ? 0 : i + 1;
    const Vec3f& here = mesh.positions[face[i]];
    return corner_normal<Vec3f>(mesh.positions[face[after]] - here, mesh.positions[face[before]] - here);
}

using EdgeKey = std::uint64_t;
EdgeKey key_of(std::uint32_t a, std::uint32_t b) {
    return static_cast<EdgeKey>(std::min(a, b)) << 32 | std::max(a, b);
}

std::vector<EdgeKey> sharp_edges(const QuadMesh& mesh) {
    std::vector<EdgeKey> keys;
    for (const Crease& crease : mesh.features.creases)
        if (crease.sharpness >= 1) keys.push_back(key_of(crease.edge[0], crease.edge[1]));
    std::sort(keys.begin(), keys.end());
    return keys;
}

/// A corner at the end of a sharp edge, and the edges of its face that meet there.
struct SharpCorner {
    std::uint32_t vertex, corner;
    EdgeKey in, out;
    Vec3f share;
};

std::vector<SharpCorner> sharp_corners(const QuadMesh& mesh, const std::vector<EdgeKey>& sharp) {
    std::vector<bool> at_sharp(mesh.vertex_count(), false);
    for (const EdgeKey key : sharp) at_sharp[key >> 32] = at_sharp[key & 0xffffffffu] = true;
    std::vector<SharpCorner> corners;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        const std::size_t n = face.size();
        for (std::size_t i = 0; i < n; ++i) {
            if (!at_sharp[face[i]]) continue;
            corners.push_back({face[i], static_cast<std::uint32_t>(mesh.face_offsets[f] + i),
                               key_of(face[(i + n - 1) % n], face[i]), key_of(face[i], face[(i + 1) % n]),
                               share_of(mesh, face, i)});
        }
    }
    std::stable_sort(corners.begin(), corners.end(),
                     [](const SharpCorner& a, const SharpCorner& b) { return a.vertex < b.vertex; });
    return corners;
}

/// Normals of the corners round one vertex: those that are not parted by a sharp edge share one.
void split(std::span<const SharpCorner> around, const std::vector<EdgeKey>& sharp,
           std::vector<SplitNormal>& splits) {
    std::vector<std::size_t> group(around.size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    for (std::size_t i = 0; i < around.size(); ++i) {
        if (std::binary_search(sharp.begin(), sharp.end(), around[i].out)) continue;
        for (std::size_t j = 0; j < around.size(); ++j)
            if (around[j].in == around[i].out)
                std::replace(group.begin(), group.end(), std::size_t(group[j]), std::size_t(group[i]));
    }
    for (std::size_t i = 0; i < around.size(); ++i) {
        Vec3f sum = Vec3f::Zero();
        for (std::size_t j = 0; j < around.size(); ++j)
            if (group[j] == group[i]) sum += around[j].share;
        splits.push_back({around[i].corner, unit(sum)});
    }
}

std::vector<SplitNormal> split_normals(const QuadMesh& mesh) {
    const std::vector<EdgeKey> sharp = sharp_edges(mesh);
    std::vector<SplitNormal> splits;
    if (sharp.empty()) return splits;
    const std::vector<SharpCorner> corners = sharp_corners(mesh, sharp);
    for (std::size_t begin = 0, end = 0; begin < corners.size(); begin = end) {
        while (end < corners.size() && corners[end].vertex == corners[begin].vertex) ++end;
        split({corners.data() + begin, end - begin}, sharp, splits);
    }
    std::sort(splits.begin(), splits.end(),
              [](const SplitNormal& a, const SplitNormal& b) { return a.corner < b.corner; });
    return splits;
}

/// Calls body(i) for all numbers below a count, in pieces that are worth a task.
template <class Body>
void for_each_below(std::size_t count, const Body& body) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 4096), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
    });
}

/// The shares of a quad's corners: as share_of, with each side of the face looked at once.
void shares_of_quad(const QuadMesh& mesh, const std::uint32_t* face, Vec3f* shares) {
    Vec3f side[4];
    float square[4];
    for (int i = 0; i < 4; ++i) {
        side[i] = mesh.positions[face[(i + 1) % 4]] - mesh.positions[face[i]];
        square[i] = side[i].squaredNorm();
    }
    for (int i = 0; i < 4; ++i) {
        const int before = (i + 3) % 4;
        shares[i] = corner_normal<Vec3f>(side[i], -side[before], square[i] * square[before]);
    }
}

}  // namespace

Normals normals_of(const QuadMesh& mesh) {
    Normals normals{std::vector<Vec3f>(mesh.face_count()),
                    std::vector<Vec3f>(mesh.vertex_count(), Vec3f::Zero()), split_normals(mesh)};
    std::vector<Vec3f> shares(mesh.corners.size());
    for_each_below(mesh.face_count(), [&](std::size_t f) {
        const auto face = mesh.face(f);
        Vec3f* const of_face = shares.data() + mesh.face_offsets[f];
        normals.faces[f] = unit(area_vector(mesh, face));
        if (face.size() == 4) return shares_of_quad(mesh, face.data(), of_face);
        for (std::size_t i = 0; i < face.size(); ++i) of_face[i] = share_of(mesh, face, i);
    });
    // In the order of the corners, on one thread: a sum of floats depends on its order.
    for (std::size_t corner = 0; corner < shares.size(); ++corner)
        normals.vertices[mesh.corners[corner]] += shares[corner];
    for_each_below(mesh.vertex_count(),
                   [&](std::size_t v) { normals.vertices[v] = unit(normals.vertices[v]); });
    return normals;
}

}  // namespace sinew
