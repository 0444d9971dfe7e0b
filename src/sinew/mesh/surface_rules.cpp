#include "sinew/mesh/surface_rules.h"

#include <fmt/format.h>

#include <algorithm>

namespace sinew {
namespace {

bool repeats(std::span<const std::uint32_t> face) {
    for (std::size_t i = 1; i < face.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (face[i] == face[j]) return true;
    return false;
}

/// The same for faces of many corners.
bool repeats_sorted(std::span<const std::uint32_t> face, std::vector<std::uint32_t>& sorted) {
    sorted.assign(face.begin(), face.end());
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

/// What never moves, or lies on a circle of a plane, needs no care to stay in it.
void leave_out_what_stays(const Sharpness& sharpness, const Rounds& rounds, Flats& flats) {
    std::vector<std::uint32_t> vertices, edges;
    for (std::size_t i = 0; i < sharpness.vertices.size(); ++i)
        if (sharpness.corner[i]) vertices.push_back(sharpness.vertices[i]);
    for (const CircleVertex& place : rounds.vertices) vertices.push_back(place.vertex);
    for (const CircleEdge& place : rounds.edges) edges.push_back(place.edge);
    std::sort(vertices.begin(), vertices.end());
    std::sort(edges.begin(), edges.end());
    const auto within = [](const std::vector<std::uint32_t>& list) {
        return
            [&list](const Flats::Entry& e) { return std::binary_search(list.begin(), list.end(), e.item); };
    };
    std::erase_if(flats.vertices, within(vertices));
    std::erase_if(flats.edges, within(edges));
}

}  // namespace

Result<void> check_control_mesh(const QuadMesh& mesh) {
    if (!well_formed(mesh))
        return fail(ErrorKind::input, "the mesh names vertices or corners that it has not");
    if (mesh.corners.size() >= no_index) return fail(ErrorKind::input, "the mesh has 2^32 corners or more");
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
        if (!mesh.positions[v].allFinite())
            return fail(ErrorKind::input, fmt::format("vertex {} of the mesh has no finite position", v));
    std::vector<std::uint32_t> scratch;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        if (face.size() < 3)
            return fail(ErrorKind::input, fmt::format("face {} of the mesh has fewer than three corners", f));
        if (face.size() > 16 ? repeats_sorted(face, scratch) : repeats(face))
            return fail(ErrorKind::input, fmt::format("face {} of the mesh has a vertex twice", f),
                        "remove or split such faces");
    }
    return {};
}

Result<SurfaceRules> resolve_rules(const QuadMesh& mesh, const Topology& topology,
                                   std::span<const std::uint32_t> poles) {
    auto sharpness = resolve_sharpness(mesh, topology);
    if (!sharpness) return fail(sharpness.error());
    auto flats = resolve_flats(mesh, topology);
    if (!flats) return fail(flats.error());
    auto fans = resolve_fans(mesh, topology, *sharpness, poles);
    if (!fans) return fail(fans.error());
    auto rounds = resolve_rounds(mesh, topology, *sharpness, *fans);
    if (!rounds) return fail(rounds.error());
    leave_out_what_stays(*sharpness, *rounds, *flats);
    return SurfaceRules{std::move(*sharpness), std::move(*fans), std::move(*rounds), std::move(*flats)};
}

}  // namespace sinew
