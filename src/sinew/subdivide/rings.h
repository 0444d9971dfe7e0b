/// @file rings.h
/// The slots round each vertex of a level. They need no table of their own: a vertex that was new in some
/// split has its place in the tables of the level that was split, and from split to split slot s at a vertex
/// becomes slot 4 s.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "sinew/subdivide/level.h"

namespace sinew {

/// Calls body(vertex, slots) for all vertices that the control mesh has after `splits` splits, in parallel.
/// Slots are those of that level, counter-clockwise; none at poles of fans and at vertices without faces.
/// @param levels  from the control mesh on; at least `splits`, and one
template <class Body>
void for_each_ring(std::span<const Level> levels, std::size_t splits, const Body& body);

/// The same for the vertices that were there before the last split.
template <class Body>
void for_each_old_ring(std::span<const Level> levels, std::size_t splits, const Body& body);

/// The slots round one vertex.
std::vector<std::uint32_t> ring_of(std::span<const Level> levels, std::size_t splits, std::uint32_t vertex);

namespace detail {

template <class Body>
void for_each_block(std::uint32_t count, const Body& body) {
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, count, 2048),
                      [&](const auto& range) { body(range.begin(), range.end()); });
}

template <class Body>
void control_rings(const Level& level, std::size_t shift, const Body& body) {
    for_each_block(level.vertices, [&](std::uint32_t begin, std::uint32_t end) {
        std::vector<std::uint32_t> row;
        for (std::uint32_t v = begin; v < end; ++v) {
            row.assign(level.ring.begin() + level.ring_first[v],
                       level.ring.begin() + level.ring_first[v + 1]);
            for (std::uint32_t& slot : row) slot <<= shift;
            body(v, std::span<const std::uint32_t>(row));
        }
    });
}

template <class Faces, class Body>
void edge_point_rings(const Level& level, const Faces& faces, std::size_t shift, const Body& body) {
    for_each_block(level.edge_count(), [&](std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t edge = begin; edge < end; ++edge) {
            auto row = ring_of_edge_point(level, faces, edge);
            const bool open = row[2] == no_index;
            for (std::uint32_t& slot : row) slot <<= shift;
            if (open)
                body(level.edge_point(edge), std::span<const std::uint32_t, 2>(row.data(), 2));
            else
                body(level.edge_point(edge), std::span<const std::uint32_t, 4>(row));
        }
    });
}

template <class Faces, class Body>
void face_point_rings(const Level& level, const Faces& faces, std::size_t shift, const Body& body) {
    for_each_block(level.faces, [&](std::uint32_t begin, std::uint32_t end) {
        std::vector<std::uint32_t> row;
        for (std::uint32_t face = begin; face < end; ++face) {
            row.clear();
            for (std::uint32_t slot = faces.begin(face); slot < faces.end(face); ++slot)
                row.push_back((4 * slot + 2) << shift);
            body(level.face_point(face), std::span<const std::uint32_t>(row));
        }
    });
}

template <class Body>
void face_point_rings(const Level& level, const Quads&, std::size_t shift, const Body& body) {
    for_each_block(level.faces, [&](std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t face = begin; face < end; ++face) {
            const std::uint32_t slot = (16 * face + 2) << shift, step = 4u << shift;
            const std::array row{slot, slot + step, slot + 2 * step, slot + 3 * step};
            body(level.face_point(face), std::span<const std::uint32_t, 4>(row));
        }
    });
}

}  // namespace detail

namespace detail {

/// Of the vertices of the control mesh and those that the first `made` of the splits made.
template <class Body>
void rings_made_by(std::span<const Level> levels, std::size_t splits, std::size_t made, const Body& body) {
    control_rings(levels[0], 2 * splits, body);
    for (std::size_t split = 0; split < made; ++split) {
        const std::size_t shift = 2 * (splits - split - 1);
        with_faces(levels[split], [&](const auto& faces) {
            edge_point_rings(levels[split], faces, shift, body);
            face_point_rings(levels[split], faces, shift, body);
        });
    }
}

}  // namespace detail

template <class Body>
void for_each_ring(std::span<const Level> levels, std::size_t splits, const Body& body) {
    detail::rings_made_by(levels, splits, splits, body);
}

template <class Body>
void for_each_old_ring(std::span<const Level> levels, std::size_t splits, const Body& body) {
    detail::rings_made_by(levels, splits, splits - 1, body);
}

inline std::vector<std::uint32_t> ring_of(std::span<const Level> levels, std::size_t splits,
                                          std::uint32_t vertex) {
    std::size_t split =
        0;  // the one that made the vertex; `splits` more than there are for one of the control mesh
    while (split < splits && vertex >= levels[split].face_point(levels[split].faces)) ++split;
    std::vector<std::uint32_t> row;
    const Level& level = levels[split];
    std::size_t shift = 2 * (splits - split - 1);
    if (vertex < levels[0].vertices) {
        row.assign(levels[0].ring.begin() + levels[0].ring_first[vertex],
                   levels[0].ring.begin() + levels[0].ring_first[vertex + 1]);
        shift = 2 * splits;
    } else if (vertex < level.face_point(0)) {
        with_faces(level, [&](const auto& faces) {
            for (const std::uint32_t slot : ring_of_edge_point(level, faces, vertex - level.vertices))
                if (slot != no_index) row.push_back(slot);
        });
    } else {
        with_faces(level, [&](const auto& faces) {
            const std::uint32_t face = vertex - level.face_point(0);
            for (std::uint32_t slot = faces.begin(face); slot < faces.end(face); ++slot)
                row.push_back(4 * slot + 2);
        });
    }
    for (std::uint32_t& slot : row) slot <<= shift;
    return row;
}

}  // namespace sinew
