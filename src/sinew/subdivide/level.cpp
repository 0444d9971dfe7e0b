#include "sinew/subdivide/level.h"

#include <algorithm>

#include "sinew/subdivide/parallel.h"

namespace sinew {
namespace {

using Index = std::uint32_t;

/// Brings a mesh and its topology into slots: as half-edges, but a fan's triangle starts at the pole and has
/// a fourth.
class ControlLevel {
  public:
    ControlLevel(const QuadMesh& mesh, const Topology& topology, const Fans& fans)
        : mesh_(mesh), topology_(topology), fans_(fans) {}

    Level build() {
        level_.vertices = static_cast<Index>(mesh_.vertex_count());
        level_.faces = static_cast<Index>(mesh_.face_count());
        level_.triangles = fans_.faces;
        std::sort(level_.triangles.begin(), level_.triangles.end());
        place_faces();
        turn_fans();
        fill_slots();
        fill_edges();
        fill_rings();
        return std::move(level_);
    }

  private:
    /// Slot of a half-edge.
    Index slot_of(Index half_edge) const {
        const Index face = topology_.half_edge_face[half_edge];
        const Index begin = mesh_.face_offsets[face], corner = half_edge - begin;
        const Index size = mesh_.face_offsets[face + 1] - begin;
        return level_.first[face] + (corner + size - start_[face]) % size;
    }

    void place_faces() {
        level_.first.resize(level_.faces + 1);
        std::size_t fan = 0;
        for (Index face = 0; face <= level_.faces; ++face) {
            level_.first[face] = mesh_.face_offsets[face] + static_cast<Index>(fan);
            fan += fan < level_.triangles.size() && level_.triangles[fan] == face;
        }
    }

    /// Finds the corner at which the slots of each face start.
    void turn_fans() {
        start_.assign(level_.faces, 0);
        for (const PoleFan& fan : fans_.fans)
            for (const Index face : fans_.faces_of(fan))
                start_[face] = static_cast<Index>(std::ranges::find(mesh_.face(face), fan.pole) -
                                                  mesh_.face(face).begin());
    }

    void fill_slots() {
        const Index slots = level_.first.back();
        level_.corners.resize(slots);
        level_.slot_edge.resize(slots);
        level_.slot_face.resize(slots);
        for_each_in_parallel(static_cast<Index>(mesh_.corners.size()), [&](Index h) {
            const Index slot = slot_of(h);
            level_.corners[slot] = mesh_.corners[h];
            level_.slot_edge[slot] = topology_.half_edge_edge[h];
            level_.slot_face[slot] = topology_.half_edge_face[h];
        });
        for (const Index face : level_.triangles) {
            const Index slot = level_.first[face];
            level_.corners[slot + 3] = level_.corners[slot];
            level_.slot_edge[slot + 3] = no_index;
            level_.slot_face[slot + 3] = face;
        }
    }

    void fill_edges() {
        level_.edges.resize(topology_.edge_count());
        for_each_in_parallel(level_.edge_count(), [&](Index edge) {
            const Index h = topology_.half_edges(edge)[0], twin = topology_.twin[h];
            level_.edges[edge] = {slot_of(h), twin == no_index ? no_index : slot_of(twin)};
        });
    }

    void fill_rings() {
        std::vector<Index> pole(level_.vertices, 0);
        for (const PoleFan& fan : fans_.fans) pole[fan.pole] = 1;
        level_.ring_first.assign(1, 0);
        level_.ring_first.reserve(level_.vertices + 1);
        level_.ring.reserve(mesh_.corners.size());
        for (Index v = 0; v < level_.vertices; ++v) {
            if (!pole[v])
                for (const Index h : topology_.ring(v)) level_.ring.push_back(slot_of(h));
            level_.ring_first.push_back(static_cast<Index>(level_.ring.size()));
        }
    }

    const QuadMesh& mesh_;
    const Topology& topology_;
    const Fans& fans_;
    std::vector<Index> start_;
    Level level_;
};

/// Which half of an edge is at the vertex that a slot of the edge leaves, 0 or 1.
Index half_of_slot(const Level& level, Index edge, Index slot) {
    const auto [left, right] = level.edges[edge];
    if (slot == left) return 0;
    if (slot == right) return 1;
    return level.corners[left] == level.corners[slot] ? 0 : 1;
}

template <class Faces>
void fill_finer_faces(const Level& level, const Faces& faces, Level& finer) {
    const Index edges = level.edge_count();
    const auto half = [&](Index slot, bool far) {
        const Index edge = level.slot_edge[slot];
        return edge == no_index ? no_index : 2 * edge + (half_of_slot(level, edge, slot) ^ Index{far});
    };
    for_each_in_parallel(level.faces, [&](Index face) {
        for (Index slot = faces.begin(face), before = faces.end(face) - 1; slot < faces.end(face);
             before = slot++) {
            const auto corners = finer_face(level, faces, slot);
            std::copy(corners.begin(), corners.end(), finer.corners.begin() + 4 * slot);
            Index* const edge = finer.slot_edge.data() + 4 * slot;
            edge[0] = half(slot, false);
            edge[1] = 2 * edges + slot;
            edge[2] = 2 * edges + before;
            edge[3] = half(before, true);
            finer.edges[2 * edges + before] = {4 * before + 1, 4 * slot + 2};
        }
    });
}

template <class Faces>
void fill_finer_edges(const Level& level, const Faces& faces, Level& finer) {
    for_each_in_parallel(level.edge_count(), [&](Index edge) {
        const auto ring = ring_of_edge_point(level, faces, edge);
        const auto [left, right] = level.edges[edge];
        finer.edges[2 * edge] = {4 * left, ring[2]};
        finer.edges[2 * edge + 1] = {ring[0], right == no_index ? no_index : 4 * right};
    });
}

}  // namespace

Level control_level(const QuadMesh& mesh, const Topology& topology, const Fans& fans) {
    return ControlLevel(mesh, topology, fans).build();
}

Level finer_level(const Level& level) {
    Level finer;
    finer.vertices = level.vertices + level.edge_count() + level.faces;
    finer.faces = level.slot_count();
    finer.corners.resize(4 * std::size_t{finer.faces});
    finer.slot_edge.resize(finer.corners.size());
    finer.edges.resize(2 * level.edges.size() + finer.faces);
    finer.triangles = finer_triangles(level);
    with_faces(level, [&](const auto& faces) {
        fill_finer_faces(level, faces, finer);
        fill_finer_edges(level, faces, finer);
    });
    return finer;
}

std::vector<std::uint32_t> finer_triangles(const Level& level) {
    std::vector<Index> finer;
    finer.reserve(2 * level.triangles.size());
    for (const Index face : level.triangles) {
        const Index slot = level.first.empty() ? 4 * face : level.first[face];
        finer.push_back(slot);  // the two slots at the pole: the first, and the last or the second
        finer.push_back(level.slot_edge[slot] == no_index ? slot + 1 : slot + 3);
    }
    return finer;
}

}  // namespace sinew
