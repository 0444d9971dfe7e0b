#include "sinew/subdivide/carry.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "sinew/subdivide/parallel.h"

namespace sinew {
namespace {

using Index = std::uint32_t;

/// Number of vertices one level finer.
std::size_t vertices_after(const Level& level) { return std::size_t{level.face_point(0)} + level.faces; }

/// Number of entries of an ascending list below a value.
Index count_below(std::span<const Index> list, Index value) {
    return static_cast<Index>(std::lower_bound(list.begin(), list.end(), value) - list.begin());
}

template <class Faces>
void write_quads(const Level& level, const Faces& faces, QuadMesh& finer) {
    for_each_in_parallel(level.slot_count(), [&](Index slot) {
        const auto corners = finer_face(level, faces, slot);
        std::copy(corners.begin(), corners.end(), finer.corners.begin() + 4 * std::ptrdiff_t{slot});
        finer.face_offsets[slot + 1] = 4 * (slot + 1);
    });
}

template <class Faces>
void write_quads_and_triangles(const Level& level, const Faces& faces, std::span<const Index> triangles,
                               QuadMesh& finer) {
    tbb::parallel_for(tbb::blocked_range<Index>(0, level.slot_count(), 2048), [&](const auto& range) {
        Index before = count_below(triangles, range.begin());
        for (Index slot = range.begin(); slot < range.end(); ++slot) {
            const auto corners = finer_face(level, faces, slot);
            const bool triangle = before < triangles.size() && triangles[before] == slot;
            // A triangle has its pole twice: first and last, or first and second.
            const Index skip = triangle && corners[0] == corners[1] ? 1 : 0;
            const Index size = triangle ? 3 : 4;
            std::copy_n(corners.begin() + skip, size,
                        finer.corners.begin() + (4 * std::ptrdiff_t{slot} - before));
            before += triangle;
            finer.face_offsets[slot + 1] = 4 * (slot + 1) - before;
        }
    });
}

/// Node, bone and the like of the vertices of the finer level, appended to those of the coarser one.
class OriginWriter {
  public:
    /// @param vertices  of the finest level
    OriginWriter(const QuadMesh& mesh, std::size_t vertices, QuadMesh& finest) : finest_(finest) {
        copy(mesh.vertex_node, vertices, finest_.vertex_node);
        copy(mesh.vertex_bone, vertices, finest_.vertex_bone);
        copy(mesh.vertex_along, vertices, finest_.vertex_along);
    }

    void split(const Level& level) {
        const std::size_t vertices = vertices_after(level);
        for (auto* list : {&finest_.vertex_node, &finest_.vertex_bone})
            if (!list->empty()) list->resize(vertices);
        if (!finest_.vertex_along.empty()) finest_.vertex_along.resize(vertices);
        with_faces(level, [&](const auto& faces) {
            for_each_in_parallel(level.edge_count(), [&](Index edge) {
                const auto ends = ends_of(level, faces, edge);
                const auto [low, high] = std::minmax(ends[0], ends[1]);
                write(level.edge_point(edge), std::array{low, high});
            });
            for_each_in_parallel(level.faces, [&](Index face) {
                write(level.face_point(face), std::span(level.corners.data() + faces.begin(face),
                                                        level.corners.data() + faces.end(face)));
            });
        });
    }

  private:
    template <class T>
    static void copy(const std::vector<T>& from, std::size_t vertices, std::vector<T>& to) {
        if (from.empty()) return;
        reserve_large(to, vertices);
        to.assign(from.begin(), from.end());
    }

    void write(Index vertex, std::span<const Index> parents) {
        if (!finest_.vertex_node.empty()) finest_.vertex_node[vertex] = finest_.vertex_node[parents[0]];
        if (!finest_.vertex_bone.empty()) finest_.vertex_bone[vertex] = finest_.vertex_bone[parents[0]];
        if (!finest_.vertex_along.empty()) finest_.vertex_along[vertex] = mean_along(parents);
    }

    float mean_along(std::span<const Index> parents) const {
        const auto& bone = finest_.vertex_bone;
        float sum = 0, count = 0;
        for (const Index parent : parents) {
            if (!bone.empty() && bone[parent] != bone[parents[0]]) continue;
            sum += finest_.vertex_along[parent];
            ++count;
        }
        return sum / count;
    }

    QuadMesh& finest_;
};

std::vector<Crease> finer_creases(const Level& level, const Sharpness& coarse) {
    std::vector<Crease> finer;
    for (const auto& [edge, coarse_sharpness, listed] : coarse.edges) {
        const float sharpness = finer_sharpness(coarse_sharpness);
        if (!listed || !(sharpness > 0)) continue;
        for (const Index end : ends_of(level, edge))
            finer.push_back({{end, level.edge_point(edge)}, sharpness});
    }
    return finer;
}

std::vector<Circle> finer_circles(const Level& level, const Rounds& coarse,
                                  const std::vector<Circle>& control) {
    std::vector<Circle> finer;
    finer.reserve(control.size());
    for (const Circle& circle : control) finer.push_back({circle.centre, circle.axis, circle.radius, {}});
    for (const auto& [edge, circle] : coarse.edges) {
        const auto [a, b] = ends_of(level, edge);
        finer[circle].edges.push_back({a, level.edge_point(edge)});
        finer[circle].edges.push_back({level.edge_point(edge), b});
    }
    return finer;
}

/// The parts of a face of the control mesh follow each other.
std::vector<Index> parts_of_faces(std::span<const Level> levels, std::span<const Index> faces) {
    std::vector<Index> parts;
    const Index each = Index{1} << 2 * (levels.size() - 1);
    for (const Index face : faces)
        for (Index part = levels[0].first[face] * each; part < levels[0].first[face + 1] * each; ++part)
            parts.push_back(part);
    return parts;
}

}  // namespace

void write_finer_faces(const Level& level, QuadMesh& finer) {
    const std::vector<Index> triangles = finer_triangles(level);
    const std::size_t faces = level.slot_count(), corners = 4 * faces - triangles.size();
    finer.face_offsets.clear();
    reserve_large(finer.face_offsets, faces + 1);
    finer.face_offsets.resize(faces + 1);
    reserve_large(finer.corners, corners);
    finer.corners.resize(corners);
    with_faces(level, [&](const auto& shape) {
        if (triangles.empty())
            write_quads(level, shape, finer);
        else
            write_quads_and_triangles(level, shape, triangles, finer);
    });
}

void write_origins(std::span<const Level> levels, const QuadMesh& mesh, QuadMesh& finest) {
    OriginWriter writer(mesh, vertices_after(levels.back()), finest);
    for (const Level& level : levels) writer.split(level);
}

Features finest_features(std::span<const Level> levels, const SurfaceRules& rules, const Features& control) {
    Features finest;
    const Level& last = levels.back();
    finest.creases = finer_creases(last, rules.sharpness);
    finest.corners = control.corners;
    for (const PoleFan& fan : rules.fans.fans) finest.poles.push_back(fan.pole);
    finest.circles = finer_circles(last, rules.rounds, control.circles);
    for (const Plane& plane : control.planes)
        finest.planes.push_back({plane.point, plane.normal, parts_of_faces(levels, plane.faces)});
    return finest;
}

}  // namespace sinew
