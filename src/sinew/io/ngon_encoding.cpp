#include "sinew/io/ngon_encoding.h"

#include <algorithm>

#include "sinew/mesh/topology.h"

namespace sinew {
namespace {

using Index = std::uint32_t;

Triangle turned(const Triangle& t) { return {t[1], t[2], t[0]}; }

/// Does `next` go on with the fan that `before` is part of?
bool continues_fan(const Triangle& before, const Triangle& next) {
    return next[0] == before[0] && next[1] == before[2];
}

bool is_fan(std::span<const Triangle> triangles) {
    for (std::size_t i = 1; i < triangles.size(); ++i)
        if (!continues_fan(triangles[i - 1], triangles[i])) return false;
    return true;
}

/// Single triangles, each of which starts with another vertex than the one before it.
void append_apart(std::span<const Triangle> triangles, std::vector<Triangle>& list) {
    for (Triangle t : triangles) {
        if (!list.empty() && list.back()[0] == t[0]) t = turned(t);
        list.push_back(t);
    }
}

void append_polygon(std::span<const Triangle> polygon, std::vector<Triangle>& list) {
    if (polygon.empty()) return;
    const bool clash = !list.empty() && list.back()[0] == polygon[0][0];
    if (polygon.size() == 2 && clash && is_fan(polygon)) {  // the other end of the diagonal will do
        list.push_back({polygon[1][1], polygon[1][2], polygon[1][0]});
        list.push_back({polygon[1][1], polygon[0][0], polygon[0][1]});
    } else if (clash || !is_fan(polygon)) {
        append_apart(polygon, list);
    } else {
        list.insert(list.end(), polygon.begin(), polygon.end());
    }
}

}  // namespace

std::vector<Triangle> encode_ngons(const QuadMesh& mesh) {
    const Triangles cut = triangulate(mesh);
    std::vector<Triangle> list;
    list.reserve(cut.triangles.size());
    for (std::size_t f = 0; f < mesh.face_count(); ++f) append_polygon(cut.of(f), list);
    return list;
}

void decode_ngons(std::span<const Triangle> triangles, QuadMesh& mesh) {
    for (std::size_t i = 0; i < triangles.size();) {
        mesh.corners.insert(mesh.corners.end(), triangles[i].begin(), triangles[i].end());
        for (++i; i < triangles.size() && continues_fan(triangles[i - 1], triangles[i]); ++i)
            mesh.corners.push_back(triangles[i][2]);
        mesh.face_offsets.push_back(static_cast<Index>(mesh.corners.size()));
    }
}

}  // namespace sinew
