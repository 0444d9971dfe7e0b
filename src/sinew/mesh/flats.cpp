#include "sinew/mesh/flats.h"

#include <fmt/format.h>

#include <algorithm>

namespace sinew {
namespace {

using Index = std::uint32_t;

Result<void> check_plane(const QuadMesh& mesh, std::size_t number) {
    const Plane& plane = mesh.features.planes[number];
    if (!(std::abs(plane.normal.norm() - 1) < 1e-3f) || !plane.point.allFinite())
        return fail(ErrorKind::input, fmt::format("plane {} of the mesh has no unit normal", number));
    for (const Index face : plane.faces)
        if (face >= mesh.face_count())
            return fail(ErrorKind::input,
                        fmt::format("plane {} has a face {} that the mesh has not", number, face));
    return {};
}

void sort_unique(std::vector<Flats::Entry>& entries) {
    std::sort(entries.begin(), entries.end());
    entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
}

}  // namespace

Result<Flats> resolve_flats(const QuadMesh& mesh, const Topology& topology) {
    Flats flats;
    if (mesh.features.planes.empty()) return flats;
    std::vector<char> inside(mesh.face_count(), 0);
    for (Index p = 0; p < mesh.features.planes.size(); ++p) {
        if (auto sound = check_plane(mesh, p); !sound) return fail(sound.error());
        const std::vector<Index>& faces = mesh.features.planes[p].faces;
        for (const Index face : faces) inside[face] = 1;
        const auto leaves = [&](Index h) {
            const Index twin = topology.twin[h];
            return twin == no_index || !inside[topology.half_edge_face[twin]];
        };
        for (const Index face : faces)
            for (Index h = mesh.face_offsets[face]; h < mesh.face_offsets[face + 1]; ++h)
                if (leaves(h)) {
                    flats.edges.push_back({topology.half_edge_edge[h], p});
                    flats.vertices.push_back({mesh.corners[h], p});
                    flats.vertices.push_back({mesh.corners[next_half_edge(mesh, topology, h)], p});
                }
        for (const Index face : faces) inside[face] = 0;
    }
    sort_unique(flats.edges);
    sort_unique(flats.vertices);
    return flats;
}

Vec3 nearest_in_planes(std::span<const Plane> planes, std::span<const Flats::Entry> entries, Vec3 point) {
    Vec3 used[3];
    int count = 0;
    for (const Flats::Entry& entry : entries) {
        const Vec3 normal = planes[entry.plane].normal.cast<double>();
        Vec3 way = normal;  // to the plane, within those before it
        for (int i = 0; i < count; ++i) way -= normal.dot(used[i]) * used[i];
        if (count == 3 || way.norm() < 1e-3) continue;
        used[count] = way.normalized();
        point -= (point - planes[entry.plane].point.cast<double>()).dot(normal) / used[count].dot(normal) *
                 used[count];
        ++count;
    }
    return point;
}

}  // namespace sinew
