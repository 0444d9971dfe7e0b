#include "sinew/subdivide/finer_rules.h"

namespace sinew {
namespace {

using Index = std::uint32_t;

/// Vertices that were sharp before, as far as they still are.
void keep_vertices(const Level& level, const Sharpness& coarse, Sharpness& finer) {
    for (std::size_t i = 0; i < coarse.vertices.size(); ++i) {
        const Index vertex = coarse.vertices[i];
        const std::size_t before = finer.spokes.size();
        for (const SharpSpoke& spoke : coarse.spokes_of(i))
            if (const float sharpness = finer_sharpness(spoke.sharpness); sharpness > 0)
                finer.spokes.push_back(
                    {half_at(level, spoke.edge, vertex), level.edge_point(spoke.edge), sharpness});
        if (finer.spokes.size() == before && !coarse.corner[i]) continue;
        finer.vertices.push_back(vertex);
        finer.corner.push_back(coarse.corner[i]);
        finer.first.push_back(static_cast<Index>(finer.spokes.size()));
    }
}

/// The new points of edges that stay sharp.
void add_vertices(const Level& level, const Sharpness& coarse, Sharpness& finer) {
    for (const auto& [edge, coarse_sharpness, listed] : coarse.edges) {
        const float sharpness = finer_sharpness(coarse_sharpness);
        if (!(sharpness > 0)) continue;
        const auto [a, b] = ends_of(level, edge);
        finer.edges.push_back({2 * edge, sharpness, listed});
        finer.edges.push_back({2 * edge + 1, sharpness, listed});
        finer.spokes.push_back({2 * edge, a, sharpness});
        finer.spokes.push_back({2 * edge + 1, b, sharpness});
        finer.vertices.push_back(level.edge_point(edge));
        finer.corner.push_back(0);
        finer.first.push_back(static_cast<Index>(finer.spokes.size()));
    }
}

/// The slot of a fan's triangle that runs from the pole along its first spoke, and the slot at the pole of
/// the part that comes second round the pole.
std::array<Index, 2> slots_at_pole(const Level& level, Index triangle) {
    const Index begin = level.first.empty() ? 4 * triangle : level.first[triangle];
    if (level.slot_edge[begin] == no_index) return {begin + 1, begin};
    return {begin, begin + 3};
}

void add_circle_edge(const Level& level, const CircleEdge& place, Rounds& finer) {
    const auto [edge, circle] = place;
    const auto [a, b] = ends_of(level, edge);
    finer.edges.push_back({2 * edge, circle});
    finer.edges.push_back({2 * edge + 1, circle});
    finer.vertices.push_back({level.edge_point(edge), circle, a, b, 2 * edge, 2 * edge + 1});
}

Cone finer_cone(const Level& level, const Cone& coarse) {
    Cone finer{.tip = coarse.tip, .circle = coarse.circle};
    finer.faces.reserve(4 * coarse.faces.size());
    with_faces(level, [&](const auto& faces) {
        for (const Index face : coarse.faces)
            for (Index slot = faces.begin(face); slot < faces.end(face); ++slot) finer.faces.push_back(slot);
    });
    return finer;
}

}  // namespace

Sharpness finer_sharpness(const Level& level, const Sharpness& coarse) {
    Sharpness finer;
    keep_vertices(level, coarse, finer);
    add_vertices(level, coarse, finer);
    return finer;
}

Fans finer_fans(const Level& level, const Fans& coarse) {
    Fans finer;
    for (const PoleFan& fan : coarse.fans) {
        finer.fans.push_back({fan.pole, static_cast<Index>(finer.faces.size()), 2 * fan.valence, fan.fixed});
        for (const Index face : coarse.faces_of(fan)) {
            const auto [spoke, second] = slots_at_pole(level, face);
            finer.faces.insert(finer.faces.end(), {spoke, second});
            finer.ring.insert(finer.ring.end(),
                              {level.edge_point(level.slot_edge[spoke]), level.face_point(face)});
        }
    }
    return finer;
}

Rounds finer_rounds(const Level& level, const Rounds& coarse) {
    Rounds finer;
    finer.vertices = coarse.vertices;
    for (CircleVertex& place : finer.vertices) {
        if (place.before == no_index) continue;
        place.before = level.edge_point(place.before_edge);
        place.after = level.edge_point(place.after_edge);
        place.before_edge = half_at(level, place.before_edge, place.vertex);
        place.after_edge = half_at(level, place.after_edge, place.vertex);
    }
    for (const CircleEdge& place : coarse.edges) add_circle_edge(level, place, finer);
    for (const Cone& cone : coarse.cones) finer.cones.push_back(finer_cone(level, cone));
    return finer;
}

Flats finer_flats(const Level& level, const Flats& coarse) {
    Flats finer;
    finer.vertices = coarse.vertices;
    for (const auto& [edge, plane] : coarse.edges) finer.vertices.push_back({level.edge_point(edge), plane});
    for_each_item(coarse.edges, [&](Index edge, std::span<const Flats::Entry> entries) {
        for (const Index half : {2 * edge, 2 * edge + 1})
            for (const Flats::Entry& entry : entries) finer.edges.push_back({half, entry.plane});
    });
    return finer;
}

SurfaceRules finer_rules(const Level& level, const SurfaceRules& coarse) {
    return {finer_sharpness(level, coarse.sharpness), finer_fans(level, coarse.fans),
            finer_rounds(level, coarse.rounds), finer_flats(level, coarse.flats)};
}

}  // namespace sinew
