#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "sinew/mesh/limit.h"
#include "sinew/mesh/limit_rings.h"

namespace sinew {
namespace {

using Index = std::uint32_t;
using Term = LimitStencils::Term;

enum class Kind : char { smooth, sharp, pole, fixed };

std::vector<Kind> kinds_of(const QuadMesh& mesh, const Topology& topology, const SurfaceRules& rules,
                           std::span<const char> wanted) {
    std::vector<Kind> kinds(mesh.vertex_count(), Kind::smooth);
    for (std::size_t i = 0; i < rules.sharpness.vertices.size(); ++i)
        kinds[rules.sharpness.vertices[i]] = rules.sharpness.corner[i] ? Kind::fixed : Kind::sharp;
    for (const PoleFan& fan : rules.fans.fans) kinds[fan.pole] = fan.fixed ? Kind::fixed : Kind::pole;
    for (const CircleVertex& place : rules.rounds.vertices) kinds[place.vertex] = Kind::fixed;
    for (const Cone& cone : rules.rounds.cones)
        for (const Index face : cone.faces)
            for (const Index v : mesh.face(face)) kinds[v] = Kind::fixed;
    for (Index v = 0; v < mesh.vertex_count(); ++v)
        if (topology.ring(v).empty() || (!wanted.empty() && !wanted[v])) kinds[v] = Kind::fixed;
    return kinds;
}

/// Writes the stencils vertex by vertex: a pass that counts their terms, and one that fills them in.
class StencilBuilder {
  public:
    StencilBuilder(const QuadMesh& mesh, const Topology& topology, std::span<const char> wanted,
                   LimitStencils& stencils)
        : mesh_(mesh),
          topology_(topology),
          stencils_(stencils),
          kinds_(kinds_of(mesh, topology, stencils.rules, wanted)),
          in_fan_(mesh.face_count(), 0) {
        for (const Index face : stencils.rules.fans.faces) in_fan_[face] = 1;
    }

    void build() {
        std::vector<Index>& first = stencils_.first;
        first.assign(mesh_.vertex_count() + 1, 0);
        for_each_vertex([&](Index v) { first[v + 1] = term_count(v); });
        for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) first[v + 1] += first[v];
        stencils_.terms.resize(first.back());
        for_each_vertex([&](Index v) { fill(v, stencils_.terms.data() + first[v]); });
        fill_fan_weights();
    }

  private:
    template <class Body>
    void for_each_vertex(const Body& body) const {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mesh_.vertex_count(), 2048),
                          [&](const auto& range) {
                              for (std::size_t v = range.begin(); v < range.end(); ++v)
                                  body(static_cast<Index>(v));
                          });
    }

    std::span<const Index> ring(Index v) const { return topology_.ring(v); }
    bool is_closed(Index v) const { return topology_.twin[ring(v)[0]] != no_index; }
    std::size_t edge_count(Index v) const { return ring(v).size() + (is_closed(v) ? 0 : 1); }
    Index next(Index h) const { return next_half_edge(mesh_, topology_, h); }
    Index previous(Index h) const { return previous_half_edge(mesh_, topology_, h); }

    /// Other end of edge i round v; the last one of an open ring is seen from its last face.
    Index end_of_edge(Index v, std::size_t i) const {
        return i < ring(v).size() ? mesh_.corners[next(ring(v)[i])] : mesh_.corners[previous(ring(v)[i - 1])];
    }

    /// Corners of the face of a half-edge as the rules see it: a fan's triangle is a quad with two of them at
    /// the pole.
    Index face_size(Index h) const {
        const Index face = topology_.half_edge_face[h];
        return in_fan_[face] ? 4 : mesh_.face_offsets[face + 1] - mesh_.face_offsets[face];
    }

    Index term_count(Index v) const {
        if (kinds_[v] == Kind::fixed) return 0;
        auto count = static_cast<Index>(edge_count(v));
        if (kinds_[v] != Kind::pole)
            for (const Index h : ring(v)) count += face_size(h) - 3;
        return count;
    }

    void fill(Index v, Term* row) const {
        const double n = static_cast<double>(ring(v).size());
        if (kinds_[v] == Kind::pole) {
            for (std::size_t i = 0; i < ring(v).size(); ++i)
                row[i] = {end_of_edge(v, i), static_cast<float>(1 / (3 * n))};
        } else if (kinds_[v] == Kind::smooth) {
            const SmoothWeights weights(n);
            spread(
                v, [&](std::size_t) { return weights.edge; }, [&](std::size_t) { return weights.face; }, row);
        } else if (kinds_[v] == Kind::sharp) {
            const RingWeights weights = sharp_weights(v);
            spread(
                v, [&](std::size_t i) { return weights.edges[i]; },
                [&](std::size_t i) { return weights.faces[i]; }, row);
        }
    }

    /// Writes the weights of edges and of the faces' means, these spread over their corners.
    template <class EdgeWeight, class FaceWeight>
    void spread(Index v, const EdgeWeight& edge, const FaceWeight& face, Term* row) const {
        const std::size_t faces = ring(v).size(), edges = edge_count(v);
        const auto corner = [&](std::size_t i) { return face(i) / face_size(ring(v)[i]); };
        for (std::size_t i = 0; i < edges; ++i) {
            double weight = edge(i);
            if (i < faces) weight += corner(i);
            if (i > 0 || edges == faces) weight += corner((i + faces - 1) % faces);
            row[i] = {end_of_edge(v, i), static_cast<float>(weight)};
        }
        row += edges;
        for (std::size_t i = 0; i < faces; ++i)
            row = write_far_corners(ring(v)[i], static_cast<float>(corner(i)), row);
    }

    /// The corners of a face that are no neighbours of the vertex that h leaves; in a fan the pole once more.
    Term* write_far_corners(Index h, float weight, Term* out) const {
        const Index last = previous(h);
        if (in_fan_[topology_.half_edge_face[h]]) {
            const Index right = mesh_.corners[next(h)], left = mesh_.corners[last];
            *out++ = {is_pole(right) ? right : left, weight};
        }
        for (Index g = next(next(h)); g != last; g = next(g)) *out++ = {mesh_.corners[g], weight};
        return out;
    }

    bool is_pole(Index v) const {
        const auto& fans = stencils_.rules.fans.fans;
        const auto below = [](const PoleFan& fan, Index vertex) { return fan.pole < vertex; };
        const auto found = std::lower_bound(fans.begin(), fans.end(), v, below);
        return found != fans.end() && found->pole == v;
    }

    RingWeights sharp_weights(Index v) const {
        const Index place = find_sharp_vertex(stencils_.rules.sharpness, v);
        std::vector<float> sharpness(edge_count(v), 0);
        for (const SharpSpoke& spoke : stencils_.rules.sharpness.spokes_of(place))
            for (std::size_t i = 0; i < sharpness.size(); ++i)
                if (end_of_edge(v, i) == spoke.end) sharpness[i] = spoke.sharpness;
        return limit_weights(sharpness, is_closed(v), false);
    }

    void fill_fan_weights() {
        const Fans& fans = stencils_.rules.fans;
        stencils_.fan_weights.assign(fans.ring.size(), {0, 0, 0});
        for (const PoleFan& fan : fans.fans)
            for (Index j = fan.first; j < fan.first + fan.valence && !fan.fixed; ++j)
                stencils_.fan_weights[j] = fan_weights(fan.pole, fans.ring[j]);
    }

    /// Spoke j of a pole ends at its own point: what that is off the pole moves the spoke's end and two
    /// faces' means.
    std::array<double, 3> fan_weights(Index pole, Index v) const {
        if (kinds_[v] == Kind::fixed) return {0, 0, 0};
        if (kinds_[v] == Kind::smooth) {
            const SmoothWeights weights(static_cast<double>(ring(v).size()));
            return {weights.face / 4, weights.edge + weights.face / 2, weights.face / 4};
        }
        const RingWeights weights = sharp_weights(v);
        std::size_t i = 0;
        while (end_of_edge(v, i) != pole) ++i;
        // What comes counter-clockwise after the pole, seen from its ring, comes before it round the pole.
        const double before = weights.faces[i],
                     after = weights.faces[(i + ring(v).size() - 1) % ring(v).size()];
        return {before / 4, weights.edges[i] + (before + after) / 4, after / 4};
    }

    const QuadMesh& mesh_;
    const Topology& topology_;
    LimitStencils& stencils_;
    std::vector<Kind> kinds_;
    std::vector<char> in_fan_;
};

std::vector<Circle> without_edges(const std::vector<Circle>& circles) {
    std::vector<Circle> bare;
    bare.reserve(circles.size());
    for (const Circle& circle : circles) bare.push_back({circle.centre, circle.axis, circle.radius, {}});
    return bare;
}

std::vector<Plane> without_faces(const std::vector<Plane>& planes) {
    std::vector<Plane> bare;
    bare.reserve(planes.size());
    for (const Plane& plane : planes) bare.push_back({plane.point, plane.normal, {}});
    return bare;
}

}  // namespace

Result<LimitStencils> build_limit_stencils(const QuadMesh& mesh, std::span<const char> wanted) {
    if (auto sound = check_control_mesh(mesh); !sound) return fail(sound.error());
    const Topology topology = build_topology(mesh);
    auto rules = resolve_rules(mesh, topology, mesh.features.poles);
    if (!rules) return fail(rules.error());
    LimitStencils stencils;
    stencils.rules = std::move(*rules);
    stencils.circles = without_edges(mesh.features.circles);
    stencils.planes = without_faces(mesh.features.planes);
    StencilBuilder(mesh, topology, wanted, stencils).build();
    return stencils;
}

}  // namespace sinew
