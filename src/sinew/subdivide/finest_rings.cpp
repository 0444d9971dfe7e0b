#include "sinew/subdivide/finest_rings.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace sinew {
namespace {

using Index = std::uint32_t;

Eigen::Index row(std::size_t i) { return static_cast<Eigen::Index>(i); }

}  // namespace

FinestRings::FinestRings(const Finest& finest, std::span<const Vec3f> positions)
    : finest_(finest), positions_(positions), offsets_(finest.rules.fans.ring.size(), Vec3::Zero()) {
    const Fans& fans = finest.rules.fans;
    for (Index f = 0; f < fans.fans.size(); ++f) {
        const PoleFan& fan = fans.fans[f];
        if (fan.fixed) continue;
        for (Index j = 0; j < fan.valence; ++j) places_.push_back({fans.ring[fan.first + j], f, j});
    }
    std::sort(places_.begin(), places_.end());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, fans.fans.size(), 16), [&](const auto& range) {
        for (std::size_t f = range.begin(); f < range.end(); ++f)
            if (!fans.fans[f].fixed) find_offsets(fans.fans[f]);
    });
}

void FinestRings::find_offsets(const PoleFan& fan) {
    std::vector<Vec3> ring;
    for (const Index v : finest_.rules.fans.ring_of(fan)) ring.push_back(positions_[v].cast<double>());
    polar_offsets(ring, std::span(offsets_).subspan(fan.first, fan.valence));
}

std::vector<std::uint32_t> FinestRings::round_poles() const {
    std::vector<Index> vertices;
    for (const Place& place : places_)
        if (vertices.empty() || vertices.back() != place.vertex) vertices.push_back(place.vertex);
    return vertices;
}

RuledRing FinestRings::ring(std::uint32_t vertex) const {
    RuledRing ring;
    gather(ring, vertex);
    sharpen(ring, vertex);
    move_spokes(ring, vertex);
    return ring;
}

void FinestRings::gather(RuledRing& ring, std::uint32_t vertex) const {
    ring.slots = ring_of(finest_.levels, finest_.splits, vertex);
    const std::size_t faces = ring.slots.size();
    VertexRing& points = ring.points;
    points.vertex = positions_[vertex].cast<double>().transpose();
    points.means.resize(row(faces), 3);
    with_finest_faces(finest_, positions_, [&](const auto& see) {
        Index last = no_index;
        for (std::size_t i = 0; i < faces; ++i) {
            const SeenFace face = see(ring.slots[i]);
            ring.ends.push_back(face.next);
            points.means.row(row(i)) = face.mean.template cast<double>().transpose();
            last = face.previous;
        }
        points.closed = faces == 0 || last == ring.ends[0];
        if (!points.closed) ring.ends.push_back(last);
    });
    points.edges.resize(row(ring.ends.size()), 3);
    for (std::size_t i = 0; i < ring.ends.size(); ++i)
        points.edges.row(row(i)) = positions_[ring.ends[i]].cast<double>().transpose();
}

void FinestRings::sharpen(RuledRing& ring, std::uint32_t vertex) const {
    const Sharpness& sharpness = finest_.rules.sharpness;
    ring.points.sharpness.assign(ring.ends.size(), 0);
    const Index place = find_sharp_vertex(sharpness, vertex);
    if (place == no_index) return;
    for (const SharpSpoke& spoke : sharpness.spokes_of(place)) {
        const auto found = std::ranges::find(ring.ends, spoke.end);
        if (found != ring.ends.end())
            ring.points.sharpness[static_cast<std::size_t>(found - ring.ends.begin())] = spoke.sharpness;
    }
}

void FinestRings::move_spokes(RuledRing& ring, std::uint32_t vertex) const {
    const Fans& fans = finest_.rules.fans;
    const auto below = [](const Place& place, Index v) { return place.vertex < v; };
    auto place = std::lower_bound(places_.begin(), places_.end(), vertex, below);
    for (; place != places_.end() && place->vertex == vertex; ++place) {
        const PoleFan& fan = fans.fans[place->fan];
        const std::size_t n = fan.valence, j = place->spoke, faces = ring.slots.size();
        const auto i = static_cast<std::size_t>(std::ranges::find(ring.ends, fan.pole) - ring.ends.begin());
        const auto offset = [&](std::size_t k) { return offsets_[fan.first + k % n].transpose(); };
        ring.points.edges.row(row(i)) += offset(j);
        // Counter-clockwise after the pole is, seen from its ring, before it round the pole.
        ring.points.means.row(row(i % faces)) += (offset(j) + offset(j + n - 1)) / 4;
        ring.points.means.row(row((i + faces - 1) % faces)) += (offset(j) + offset(j + 1)) / 4;
    }
}

}  // namespace sinew
