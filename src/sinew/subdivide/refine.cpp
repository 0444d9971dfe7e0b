#include "sinew/subdivide/refine.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "sinew/subdivide/parallel.h"
#include "sinew/subdivide/rings.h"

namespace sinew {
namespace {

using Index = std::uint32_t;

Vec3 wide(const Vec3f& point) { return point.cast<double>(); }

/// Views of what a step reads and writes.
struct Points {
    const Vec3f* coarse;
    Vec3f* finer;
    Vec3f* edges;  ///< within finer
    Vec3f* faces;
};

// The smooth rules, for everything; what is special is corrected afterwards.

template <class Faces>
void make_face_points(const Level& level, const Faces& faces, const Points& points) {
    for_each_in_parallel(level.faces, [&](std::size_t f) {
        const auto face = static_cast<Index>(f);
        Vec3f sum = Vec3f::Zero();
        for (Index slot = faces.begin(face); slot < faces.end(face); ++slot)
            sum += points.coarse[level.corners[slot]];
        points.faces[face] = sum / static_cast<float>(faces.end(face) - faces.begin(face));
    });
}

template <class Faces>
void make_edge_points(const Level& level, const Faces& faces, const Points& points) {
    for_each_in_parallel(level.edge_count(), [&](std::size_t edge) {
        const auto [left, right] = level.edges[edge];
        const Vec3f ends =
            points.coarse[level.corners[left]] + points.coarse[level.corners[faces.next(left)]];
        const Vec3f& beside = points.faces[faces.face(left)];
        points.edges[edge] =
            0.25f * (ends + (beside + points.faces[faces.face(right == no_index ? left : right)]));
    });
}

template <class Faces, class Ring>
Vec3f smooth_vertex(const Level& level, const Faces& faces, const Points& points, Index vertex,
                    const Ring& ring) {
    const auto n = static_cast<float>(ring.size());
    if (ring.empty()) return points.coarse[vertex];
    Vec3f sum = Vec3f::Zero();
    for (const Index slot : ring)
        sum += points.coarse[level.corners[faces.next(slot)]] + points.faces[faces.face(slot)];
    return (n - 2) / n * points.coarse[vertex] + sum / (n * n);
}

template <class Faces>
void make_vertex_points(std::span<const Level> levels, const Faces& faces, const Points& points) {
    for_each_ring(levels, levels.size() - 1, [&](Index vertex, const auto& ring) {
        points.finer[vertex] = smooth_vertex(levels.back(), faces, points, vertex, ring);
    });
}

// Poles.

/// Offsets of the ends of all spokes, in the order of fans.ring, and means of the rings, in the order of
/// fans.fans. Those of fixed poles stay zero.
struct PolarOffsets {
    std::vector<Vec3> offsets;
    std::vector<Vec3> means;
};

PolarOffsets find_polar_offsets(const Fans& fans, const Points& points) {
    PolarOffsets result{std::vector<Vec3>(fans.ring.size(), Vec3::Zero()),
                        std::vector<Vec3>(fans.fans.size(), Vec3::Zero())};
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, fans.fans.size(), 16), [&](const auto& range) {
        std::vector<Vec3> ring;
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const PoleFan& fan = fans.fans[i];
            if (fan.fixed) continue;
            ring.clear();
            for (const Index v : fans.ring_of(fan)) ring.push_back(wide(points.coarse[v]));
            result.means[i] = polar_offsets(ring, std::span(result.offsets).subspan(fan.first, fan.valence));
        }
    });
    return result;
}

void move_fan_faces(const Fans& fans, const PolarOffsets& polar, const Points& points) {
    for (const PoleFan& fan : fans.fans)
        for (Index j = 0; j < fan.valence && !fan.fixed; ++j) {
            const Index next = j + 1 == fan.valence ? 0 : j + 1;
            const Vec3 sum = polar.offsets[fan.first + j] + polar.offsets[fan.first + next];
            points.faces[fans.faces[fan.first + j]] += (sum / 4).cast<float>();
        }
}

/// The edge of a fan's triangle from the pole to the ring vertex of the same number.
Index spoke_of(const Level& level, Index face) {
    const Index begin = level.first.empty() ? 4 * face : level.first[face];
    return level.slot_edge[level.slot_edge[begin] == no_index ? begin + 1 : begin];
}

/// What the ends of the spokes add to the new points of spokes and ring, and where the poles go.
void move_spokes_and_poles(const Level& level, const Fans& fans, const PolarOffsets& polar,
                           const Points& points) {
    for (std::size_t i = 0; i < fans.fans.size(); ++i) {
        const PoleFan& fan = fans.fans[i];
        if (fan.fixed) continue;
        for (Index j = fan.first; j < fan.first + fan.valence; ++j) {
            const Index vertex = fans.ring[j];
            const Index valence =
                level.first.empty() ? 4 : level.ring_first[vertex + 1] - level.ring_first[vertex];
            points.edges[spoke_of(level, fans.faces[j])] += (polar.offsets[j] / 4).cast<float>();
            points.finer[vertex] += (polar.offsets[j] / (double{1} * valence * valence)).cast<float>();
        }
        const Vec3 pole = wide(points.coarse[fan.pole]);
        points.finer[fan.pole] = (0.75 * pole + 0.25 * polar.means[i]).cast<float>();
    }
}

// Creases and corners.

template <class Faces>
void sharpen(const Level& level, const Faces& faces, const Sharpness& sharpness, const Points& points) {
    for_each_in_parallel(sharpness.edges.size(), [&](std::size_t i) {
        const auto& [edge, sharp, listed] = sharpness.edges[i];
        const auto [a, b] = ends_of(level, faces, edge);
        const float share = edge_rule(sharp);
        const Vec3f middle = 0.5f * (points.coarse[a] + points.coarse[b]);
        points.edges[edge] = share == 1 ? middle : Vec3f((1 - share) * points.edges[edge] + share * middle);
    });
    for_each_in_parallel(sharpness.vertices.size(), [&](std::size_t i) {
        const auto spokes = sharpness.spokes_of(i);
        const VertexRule rule = vertex_rule(spokes, sharpness.corner[i]);
        const Index vertex = sharpness.vertices[i];
        const Vec3f& old = points.coarse[vertex];
        Vec3f moved = Vec3f::Zero();
        if (rule.smooth > 0) moved += static_cast<float>(rule.smooth) * points.finer[vertex];
        if (rule.crease > 0) {
            const Vec3f ends =
                points.coarse[spokes[rule.ends[0]].end] + points.coarse[spokes[rule.ends[1]].end];
            moved += static_cast<float>(rule.crease) * (0.75f * old + 0.125f * ends);
        }
        if (rule.corner > 0) moved += static_cast<float>(rule.corner) * old;
        points.finer[vertex] = moved;
    });
}

// Circles, and the cones and discs in them.

template <class Faces>
void follow_circles(const Level& level, const Faces& faces, const Step& step, const Points& points) {
    for (const CircleVertex& place : step.rules.rounds.vertices)
        points.finer[place.vertex] = points.coarse[place.vertex];
    for_each_in_parallel(step.rules.rounds.edges.size(), [&](std::size_t i) {
        const auto& [edge, circle] = step.rules.rounds.edges[i];
        const auto [a, b] = ends_of(level, faces, edge);
        const Vec3 middle = (wide(points.coarse[a]) + wide(points.coarse[b])) / 2;
        points.edges[edge] = nearest_on_circle(step.features.circles[circle], middle).cast<float>();
    });
}

/// New points of a face of a cone, and of those of its edges that start in it.
template <class Faces>
void split_cone_face(const Level& level, const Faces& faces, Index face, const ConeMean& start,
                     const Points& points) {
    ConeMean middle = start;
    for (Index slot = faces.begin(face); slot < faces.end(face); ++slot) {
        const Vec3 here = wide(points.coarse[level.corners[slot]]);
        middle.add(here);
        const Index edge = level.slot_edge[slot];
        if (edge == no_index || level.edges[edge][0] != slot) continue;
        ConeMean half = start;
        half.add(here);
        half.add(wide(points.coarse[level.corners[faces.next(slot)]]));
        points.edges[edge] = half.mean().template cast<float>();
    }
    points.faces[face] = middle.mean().template cast<float>();
}

template <class Faces>
void follow_cone(const Level& level, const Faces& faces, const Cone& cone, const Circle& circle,
                 const Points& points) {
    const ConeMean start(circle, wide(points.coarse[cone.tip]));
    for_each_in_parallel(cone.faces.size(),
                         [&](std::size_t i) { split_cone_face(level, faces, cone.faces[i], start, points); });
    for (const Index face : cone.faces)
        for (Index slot = faces.begin(face); slot < faces.end(face); ++slot)
            points.finer[level.corners[slot]] = points.coarse[level.corners[slot]];
}

template <class Faces>
void refine(const Step& step, const Faces& faces, std::span<Vec3f> coarse, const Points& points) {
    const Level& level = step.level();
    const auto& [sharpness, fans, rounds, flats] = step.rules;
    const std::vector<Vec3f> on_circles = show_circle_controls(rounds, step.features, coarse);
    make_face_points(level, faces, points);
    const PolarOffsets polar = find_polar_offsets(fans, points);
    move_fan_faces(fans, polar, points);
    make_edge_points(level, faces, points);
    make_vertex_points(step.levels, faces, points);
    move_spokes_and_poles(level, fans, polar, points);
    sharpen(level, faces, sharpness, points);
    restore_circles(rounds, on_circles, coarse);
    follow_circles(level, faces, step, points);
    for (const Cone& cone : rounds.cones)
        follow_cone(level, faces, cone, step.features.circles[cone.circle], points);
}

}  // namespace

void refine_positions(const Step& step, std::span<Vec3f> coarse, std::span<Vec3f> finer) {
    const Level& level = step.level();
    const Points points{coarse.data(), finer.data(), finer.data() + level.edge_point(0),
                        finer.data() + level.face_point(0)};
    with_faces(level, [&](const auto& faces) { refine(step, faces, coarse, points); });
    put_in_planes(step.finer_flats, step.features, finer);
}

void put_on_circles(const Rounds& rounds, const Features& features, std::span<Vec3f> positions) {
    for (const CircleVertex& place : rounds.vertices) {
        const Circle& circle = features.circles[place.circle];
        const Vec3 point = wide(positions[place.vertex]), on = nearest_on_circle(circle, point);
        if ((on - point).norm() > 1e-6 * circle.radius) positions[place.vertex] = on.cast<float>();
    }
}

std::vector<Vec3f> show_circle_controls(const Rounds& rounds, const Features& features,
                                        std::span<Vec3f> positions) {
    std::vector<Vec3f> saved;
    saved.reserve(rounds.vertices.size());
    for (const CircleVertex& place : rounds.vertices) saved.push_back(positions[place.vertex]);
    std::vector<Vec3f> controls = saved;
    for (std::size_t i = 0; i < controls.size(); ++i) {
        const CircleVertex& place = rounds.vertices[i];
        if (place.before == no_index) continue;
        const auto at = [&](Index v) { return wide(positions[v]); };
        controls[i] = circle_control(features.circles[place.circle], at(place.vertex), at(place.before),
                                     at(place.after))
                          .cast<float>();
    }
    restore_circles(rounds, controls, positions);
    return saved;
}

void restore_circles(const Rounds& rounds, std::span<const Vec3f> saved, std::span<Vec3f> positions) {
    for (std::size_t i = 0; i < saved.size(); ++i) positions[rounds.vertices[i].vertex] = saved[i];
}

void put_in_planes(const Flats& flats, const Features& features, std::span<Vec3f> positions) {
    for_each_item(flats.vertices, [&](Index vertex, std::span<const Flats::Entry> entries) {
        positions[vertex] =
            nearest_in_planes(features.planes, entries, wide(positions[vertex])).cast<float>();
    });
}

}  // namespace sinew
