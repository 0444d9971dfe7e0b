#include "sinew/mesh/limit.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "sinew/base/portable_math.h"

namespace sinew {
namespace {

/// The control points as the neighbours of circles see them; empty where there are no circles.
template <class Vector>
std::vector<Vector> seen_beside_circles(const LimitStencils& stencils, std::span<const Vector> control) {
    if (stencils.rules.rounds.vertices.empty()) return {};
    std::vector<Vector> seen(control.begin(), control.end());
    const auto at = [&](std::uint32_t v) -> Vec3 { return control[v].template cast<double>(); };
    for (const CircleVertex& place : stencils.rules.rounds.vertices) {
        if (place.before == no_index) continue;
        const Vec3 point = circle_control(stencils.circles[place.circle], at(place.vertex), at(place.before),
                                          at(place.after));
        seen[place.vertex] = point.cast<typename Vector::Scalar>();
    }
    return seen;
}

template <class Vector>
void sum_terms(const LimitStencils& stencils, std::span<const Vector> control, std::span<Vector> limit) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, control.size(), 2048), [&](const auto& range) {
        for (std::size_t v = range.begin(); v < range.end(); ++v) {
            const Vec3 point = control[v].template cast<double>();
            Vec3 sum = Vec3::Zero();
            for (std::uint32_t i = stencils.first[v]; i < stencils.first[v + 1]; ++i) {
                const LimitStencils::Term& term = stencils.terms[i];
                sum += double{term.weight} * (control[term.vertex].template cast<double>() - point);
            }
            limit[v] = (point + sum).template cast<typename Vector::Scalar>();
        }
    });
}

/// Does the rule of a pole reach any limit that is asked for?
bool moves_ring(const LimitStencils& stencils, const PoleFan& fan) {
    const auto begin = stencils.fan_weights.begin() + fan.first;
    return std::any_of(begin, begin + fan.valence,
                       [](const std::array<double, 3>& weights) { return weights[1] != 0; });
}

template <class Vector>
void add_polar_offsets(const LimitStencils& stencils, std::span<const Vector> control,
                       std::span<Vector> limit) {
    std::vector<Vec3> ring, offsets;
    for (const PoleFan& fan : stencils.rules.fans.fans) {
        if (fan.fixed || !moves_ring(stencils, fan)) continue;
        const auto vertices = stencils.rules.fans.ring_of(fan);
        const std::size_t n = vertices.size();
        ring.resize(n);
        offsets.resize(n);
        for (std::size_t j = 0; j < n; ++j) ring[j] = control[vertices[j]].template cast<double>();
        polar_offsets(ring, offsets);
        for (std::size_t j = 0; j < n; ++j) {
            const auto& [before, same, after] = stencils.fan_weights[fan.first + j];
            const Vec3 added =
                before * offsets[(j + n - 1) % n] + same * offsets[j] + after * offsets[(j + 1) % n];
            limit[vertices[j]] += added.cast<typename Vector::Scalar>();
        }
    }
}

template <class Vector>
void keep_rounds_and_flats(const LimitStencils& stencils, std::span<const Vector> control,
                           std::span<Vector> limit) {
    for_each_item(stencils.rules.flats.vertices, [&](std::uint32_t v, std::span<const Flats::Entry> entries) {
        const Vec3 point = limit[v].template cast<double>();
        limit[v] =
            nearest_in_planes(stencils.planes, entries, point).template cast<typename Vector::Scalar>();
    });
    for (const CircleVertex& place : stencils.rules.rounds.vertices)
        limit[place.vertex] = control[place.vertex];
}

template <class Vector>
void find_limit(const LimitStencils& stencils, std::span<const Vector> control, std::span<Vector> limit) {
    assert(control.size() == stencils.vertex_count() && limit.size() == control.size());
    const std::vector<Vector> beside_circles = seen_beside_circles(stencils, control);
    const std::span<const Vector> seen =
        beside_circles.empty() ? control : std::span<const Vector>(beside_circles);
    sum_terms(stencils, seen, limit);
    add_polar_offsets(stencils, seen, limit);
    keep_rounds_and_flats(stencils, control, limit);
}

}  // namespace

void limit_positions(const LimitStencils& stencils, std::span<const Vec3> control, std::span<Vec3> limit) {
    find_limit(stencils, control, limit);
}

void limit_positions(const LimitStencils& stencils, std::span<const Vec3f> control, std::span<Vec3f> limit) {
    find_limit(stencils, control, limit);
}

Result<std::vector<Vec3f>> limit_positions(const QuadMesh& mesh) {
    const auto stencils = build_limit_stencils(mesh);
    if (!stencils) return fail(stencils.error());
    std::vector<Vec3f> limit(mesh.vertex_count());
    limit_positions(*stencils, mesh.positions, limit);
    return limit;
}

void fit_to_limit(const LimitStencils& stencils, std::span<const Vec3> target, std::span<Vec3> control,
                  int steps) {
    std::vector<Vec3> limit(control.size());
    for (int step = 0; step < steps; ++step) {
        limit_positions(stencils, std::span<const Vec3>(control), limit);
        for (std::size_t v = 0; v < control.size(); ++v) control[v] += target[v] - limit[v];
    }
}

double ring_limit_radius(int n) {
    return (4 + 2 * portable::sine_cosine(2 * std::numbers::pi / n).cosine) / 6;
}

double ring_fit_radius(int n) { return ring_limit_radius(n) / spline_radius(2 * std::numbers::pi / n); }

}  // namespace sinew
