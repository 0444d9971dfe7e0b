#include "sinew/subdivide/limit_surface.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <type_traits>

#include "sinew/subdivide/finest_rings.h"
#include "sinew/subdivide/parallel.h"
#include "sinew/subdivide/refine.h"

namespace sinew {
namespace {

using Index = std::uint32_t;

Vec3f smooth_limit(const Vec3f& point, float n, const Vec3f& edges, const Vec3f& means) {
    return (n - 1) / (n + 5) * point + (2 * edges + 4 * means) / (n * (n + 5));
}

/// The limits of vertices that are given by their rings.
template <class See>
auto ring_limits(std::span<const Vec3f> control, std::span<Vec3f> limit, const See& see) {
    return [control, limit, &see](Index vertex, const auto& ring) {
        Vec3f edges = Vec3f::Zero(), means = Vec3f::Zero();
        for (const Index slot : ring) {
            const SeenFace face = see(slot);
            edges += control[face.next];
            means += face.mean;
        }
        const auto n = static_cast<float>(ring.size());
        limit[vertex] = n > 0 ? smooth_limit(control[vertex], n, edges, means) : control[vertex];
    };
}

/// The limits of the vertices that the last split made, three quarters of all: they are regular but for the
/// middles of the control mesh's polygons, and what they need is at hand in the faces of the level before.
/// The rule is the same, summed up: (n^2 v + 4 sum of edges' ends + sum of far corners) / (n (n + 5)).
template <class Faces>
class LastSplit {
  public:
    LastSplit(const Level& level, const Faces& faces, std::span<const Vec3f> control, std::span<Vec3f> limit)
        : level_(level), faces_(faces), control_(control), limit_(limit) {}

    template <class RingLimit>
    void find(const RingLimit& of_ring) const {
        for_each_in_parallel(level_.edge_count(), [&](Index edge) {
            if (level_.edges[edge][1] != no_index) return find_at_edge(edge);
            const auto ring = ring_of_edge_point(level_, faces_, edge);
            of_ring(level_.edge_point(edge), std::span<const Index, 2>(ring.data(), 2));
        });
        for_each_in_parallel(level_.faces, [&](Index face) { find_in_face(face); });
    }

  private:
    const Vec3f& corner(Index slot) const { return control_[level_.corners[slot]]; }
    /// The new point of a slot's edge; at poles the pole.
    const Vec3f& point(Index slot) const {
        const Index edge = level_.slot_edge[slot];
        return edge == no_index ? corner(slot) : control_[level_.edge_point(edge)];
    }

    void find_at_edge(Index edge) const {
        const auto [left, right] = level_.edges[edge];
        const Index after_left = faces_.next(left), after_right = faces_.next(right);
        const Vec3f edges =
            (corner(left) + corner(after_left)) + (control_[level_.face_point(faces_.face(left))] +
                                                   control_[level_.face_point(faces_.face(right))]);
        const Vec3f far = (point(faces_.previous(left)) + point(after_left)) +
                          (point(faces_.previous(right)) + point(after_right));
        const Index vertex = level_.edge_point(edge);
        limit_[vertex] = (16 * control_[vertex] + 4 * edges + far) / 36;
    }

    void find_in_face(Index face) const {
        Vec3f edges = Vec3f::Zero(), far = Vec3f::Zero();
        for (Index slot = faces_.begin(face); slot < faces_.end(face); ++slot) {
            edges += point(slot);
            far += corner(slot);
        }
        const auto n = static_cast<float>(faces_.end(face) - faces_.begin(face));
        const Index vertex = level_.face_point(face);
        limit_[vertex] = (n * n * control_[vertex] + 4 * edges + far) / (n * (n + 5));
    }

    const Level& level_;
    const Faces& faces_;
    std::span<const Vec3f> control_;
    std::span<Vec3f> limit_;
};

void find_smooth_limits(const Finest& finest, std::span<const Vec3f> control, std::span<Vec3f> limit) {
    with_finest_faces(finest, control, [&](const auto& see) {
        const auto of_ring = ring_limits(control, limit, see);
        if (finest.splits == 0) return for_each_ring(finest.levels, 0, of_ring);
        for_each_old_ring(finest.levels, finest.splits, of_ring);
        const Level& last = finest.levels[finest.splits - 1];
        with_faces(last, [&](const auto& faces) {
            LastSplit<std::decay_t<decltype(faces)>>(last, faces, control, limit).find(of_ring);
        });
    });
}

Vec3f limit_of(const RuledRing& ring, bool corner) {
    const VertexRing& points = ring.points;
    const RingWeights weights = limit_weights(points.sharpness, points.closed, corner);
    Vec3 limit = weights.vertex * points.vertex.transpose();
    for (std::size_t i = 0; i < weights.edges.size(); ++i)
        limit += weights.edges[i] * points.edges.row(static_cast<Eigen::Index>(i)).transpose();
    for (std::size_t i = 0; i < weights.faces.size(); ++i)
        limit += weights.faces[i] * points.means.row(static_cast<Eigen::Index>(i)).transpose();
    return limit.cast<float>();
}

bool is_plain_crease(std::span<const SharpSpoke> spokes) {
    return spokes.size() == 2 && spokes[0].sharpness >= infinite_sharpness &&
           spokes[1].sharpness >= infinite_sharpness;
}

void find_sharp_limits(const Finest& finest, const FinestRings& rings, std::span<const Vec3f> control,
                       std::span<Vec3f> limit) {
    const Sharpness& sharpness = finest.rules.sharpness;
    for (std::size_t i = 0; i < sharpness.vertices.size(); ++i) {
        const Index vertex = sharpness.vertices[i];
        const auto spokes = sharpness.spokes_of(i);
        if (sharpness.corner[i])
            limit[vertex] = control[vertex];
        else if (is_plain_crease(spokes))
            limit[vertex] = (4 * control[vertex] + (control[spokes[0].end] + control[spokes[1].end])) / 6;
        else
            limit[vertex] = limit_of(rings.ring(vertex), false);
    }
}

/// Poles, and the smooth vertices round them; sharp ones come afterwards.
void find_polar_limits(const Finest& finest, const FinestRings& rings, std::span<const Vec3f> control,
                       std::span<Vec3f> limit) {
    const std::vector<Index> round = rings.round_poles();
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, round.size(), 64), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
            limit[round[i]] = limit_of(rings.ring(round[i]), false);
    });
    const Fans& fans = finest.rules.fans;
    for (const PoleFan& fan : fans.fans) {
        limit[fan.pole] = control[fan.pole];
        if (fan.fixed) continue;
        Vec3 mean = Vec3::Zero();
        for (const Index v : fans.ring_of(fan)) mean += control[v].cast<double>();
        mean /= fan.valence;
        limit[fan.pole] = ((2 * control[fan.pole].cast<double>() + mean) / 3).cast<float>();
    }
}

void keep_cone(const Finest& finest, const Cone& cone, std::span<const Vec3f> control,
               std::span<Vec3f> limit) {
    with_finest_faces(finest, control, [&](const auto& see) {
        for (const Index face : cone.faces) {
            const Index begin = finest.splits == 0 ? finest.levels[0].first[face] : 4 * face;
            const Index end = finest.splits == 0 ? finest.levels[0].first[face + 1] : begin + 4;
            for (Index slot = begin; slot < end; ++slot) {
                const Index vertex = see(slot).next;
                limit[vertex] = control[vertex];
            }
        }
    });
}

}  // namespace

void find_limit_positions(const Finest& finest, std::span<Vec3f> control, std::span<Vec3f> limit) {
    const auto& [sharpness, fans, rounds, flats] = finest.rules;
    const std::vector<Vec3f> on_circles = show_circle_controls(rounds, finest.features, control);
    find_smooth_limits(finest, control, limit);
    const FinestRings rings(finest, control);
    find_polar_limits(finest, rings, control, limit);
    find_sharp_limits(finest, rings, control, limit);
    restore_circles(rounds, on_circles, control);
    restore_circles(rounds, on_circles, limit);
    for (const Cone& cone : rounds.cones) keep_cone(finest, cone, control, limit);
    put_in_planes(flats, finest.features, limit);
}

}  // namespace sinew
