#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "sinew/subdivide/finest_rings.h"
#include "sinew/subdivide/refine.h"

namespace sinew {
namespace {

using Index = std::uint32_t;

void find_smooth_limits(const Finest& finest, std::span<const Vec3f> control, std::span<Vec3f> limit) {
    with_finest_faces(finest, control, [&](const auto& see) {
        for_each_ring(finest.levels, finest.splits, [&](Index vertex, const auto& ring) {
            const auto n = static_cast<float>(ring.size());
            Vec3f edges = Vec3f::Zero(), means = Vec3f::Zero();
            for (const Index slot : ring) {
                const SeenFace face = see(slot);
                edges += control[face.next];
                means += face.mean;
            }
            limit[vertex] = control[vertex];
            if (n > 0)
                limit[vertex] = (n - 1) / (n + 5) * control[vertex] + (2 * edges + 4 * means) / (n * (n + 5));
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
