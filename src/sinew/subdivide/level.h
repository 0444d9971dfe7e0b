/// @file level.h
/// The topology of one level of subdivision, in tables that are built once for many positions.
///
/// The faces of the finer level are the corners ("slots") of the coarser one: slot s of a face becomes face
/// s, with the corners (old vertex, new point of edge s, new point of the face, new point of the edge
/// before). So from the first level on all faces are quads and slot s is corner s % 4 of face s / 4, and
/// nothing has to be searched. The finer level's vertices are the old ones, then one for each edge, then one
/// for each face; its edges are the two halves 2e and 2e + 1 of each edge, then one for each slot, from the
/// new point of the slot's edge to that of the face.
///
/// A triangle in the fan of a pole is a quad with two corners at the pole; the slot between these two has no
/// edge, and what would be its new point is the pole itself. Its four parts are two such triangles and two
/// quads, so that the valence of the pole doubles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sinew/mesh/surface_rules.h"
#include "sinew/subdivide/table.h"

namespace sinew {

struct Level {
    std::uint32_t vertices = 0;
    std::uint32_t faces = 0;
    Table<std::uint32_t> corners;    ///< vertex of each slot
    Table<std::uint32_t> slot_edge;  ///< edge from each slot to the next of its face; no_index at poles
    /// Slots that run along each edge, in opposite directions; the second is no_index where the edge does not
    /// lie between two faces of like orientation.
    Table<std::array<std::uint32_t, 2>> edges;
    std::vector<std::uint32_t> triangles;  ///< faces in the fans of poles, ascending

    // Of the control mesh only; empty from the first level on.
    std::vector<std::uint32_t> first;       ///< slots of face f are first[f] .. first[f + 1] - 1
    std::vector<std::uint32_t> slot_face;   ///< face of each slot
    std::vector<std::uint32_t> ring_first;  ///< rows of `ring`: vertices + 1 entries
    std::vector<std::uint32_t> ring;  ///< slots at each vertex, counter-clockwise; none at poles of fans

    std::uint32_t edge_count() const { return static_cast<std::uint32_t>(edges.size()); }
    std::uint32_t slot_count() const { return static_cast<std::uint32_t>(corners.size()); }
    std::uint32_t edge_point(std::uint32_t edge) const { return vertices + edge; }
    std::uint32_t face_point(std::uint32_t face) const { return vertices + edge_count() + face; }
};

/// Faces of the control mesh.
struct Polygons {
    const Level& level;
    std::uint32_t begin(std::uint32_t face) const { return level.first[face]; }
    std::uint32_t end(std::uint32_t face) const { return level.first[face + 1]; }
    std::uint32_t face(std::uint32_t slot) const { return level.slot_face[slot]; }
    std::uint32_t next(std::uint32_t slot) const {
        return slot + 1 == end(face(slot)) ? begin(face(slot)) : slot + 1;
    }
    std::uint32_t previous(std::uint32_t slot) const {
        return (slot == begin(face(slot)) ? end(face(slot)) : slot) - 1;
    }
};

/// Faces of all other levels.
struct Quads {
    std::uint32_t begin(std::uint32_t face) const { return 4 * face; }
    std::uint32_t end(std::uint32_t face) const { return 4 * face + 4; }
    std::uint32_t face(std::uint32_t slot) const { return slot >> 2; }
    std::uint32_t next(std::uint32_t slot) const { return (slot & ~3u) | ((slot + 1) & 3u); }
    std::uint32_t previous(std::uint32_t slot) const { return (slot & ~3u) | ((slot + 3) & 3u); }
};

/// Calls body(faces) with the one or the other.
template <class Body>
void with_faces(const Level& level, const Body& body) {
    if (level.first.empty())
        body(Quads{});
    else
        body(Polygons{level});
}

/// The tables of a control mesh, which check_control_mesh passed, and of its fans.
Level control_level(const QuadMesh& mesh, const Topology& topology, const Fans& fans);

/// The tables one level finer.
Level finer_level(const Level& level);

/// Corners of face `slot` of the finer level.
template <class Faces>
std::array<std::uint32_t, 4> finer_face(const Level& level, const Faces& faces, std::uint32_t slot) {
    const auto point = [&](std::uint32_t s) {
        return level.slot_edge[s] == no_index ? level.corners[s] : level.edge_point(level.slot_edge[s]);
    };
    return {level.corners[slot], point(slot), level.face_point(faces.face(slot)),
            point(faces.previous(slot))};
}

/// The triangles of the finer level.
std::vector<std::uint32_t> finer_triangles(const Level& level);

/// The half of an edge that is at one of its vertices.
inline std::uint32_t half_at(const Level& level, std::uint32_t edge, std::uint32_t vertex) {
    return 2 * edge + (level.corners[level.edges[edge][0]] == vertex ? 0 : 1);
}

/// Both vertices of an edge.
template <class Faces>
std::array<std::uint32_t, 2> ends_of(const Level& level, const Faces& faces, std::uint32_t edge) {
    const std::uint32_t slot = level.edges[edge][0];
    return {level.corners[slot], level.corners[faces.next(slot)]};
}

inline std::array<std::uint32_t, 2> ends_of(const Level& level, std::uint32_t edge) {
    std::array<std::uint32_t, 2> ends{};
    with_faces(level, [&](const auto& faces) { ends = ends_of(level, faces, edge); });
    return ends;
}

/// Slots of the finer level at the new point of an edge, counter-clockwise: four, or two (the rest no_index).
template <class Faces>
std::array<std::uint32_t, 4> ring_of_edge_point(const Level& level, const Faces& faces, std::uint32_t edge) {
    const auto [left, right] = level.edges[edge];
    const std::array<std::uint32_t, 2> near{4 * faces.next(left) + 3, 4 * left + 1};
    if (right == no_index) return {near[0], near[1], no_index, no_index};
    return {near[0], near[1], 4 * faces.next(right) + 3, 4 * right + 1};
}

}  // namespace sinew
