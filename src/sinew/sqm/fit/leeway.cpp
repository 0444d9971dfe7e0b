#include "sinew/sqm/fit/leeway.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "sinew/mesh/limit.h"

namespace sinew::sqm {
namespace {

// Each was tried alone on nine skeletons of others at level 2 that had 302 folded quads in their control meshes; together with
// the passes of unfold() 48 are left, and the mean radius of tubes and round ends stays the same to four digits.
constexpr double most_aside = 0.1;  // of a ring's radius: how much wider or narrower than a tube's it may be
constexpr double most_of_column = 0.25;  // of the shortest edge along the tube, that a ring's point may move
constexpr double most_of_edge =
    0.4;  // of the shortest edge, that a joint's point may move: 0.5 would let both ends meet
constexpr double sharpest_mitre = 0.3;  // cosine of half a bend: from there on a mitre is as long as there
constexpr int unfold_rounds = 6;        // in which groups that fold a face go back
constexpr double back =
    0.6;  // to what is left each time of how far they have moved: a twelfth after five rounds, then nothing

Vec3 normal_of(std::span<const std::uint32_t> face, std::span<const Vec3> at) {
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
        normal += (at[face[i]] - at[face[0]]).cross(at[face[i + 1]] - at[face[0]]);
    return normal;
}

/// Whether a corner of the face turns against a direction.
bool is_folded(std::span<const std::uint32_t> face, std::span<const Vec3> at, const Vec3& up) {
    const std::size_t n = face.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 &a = at[face[i]], &b = at[face[(i + 1) % n]], &c = at[face[(i + 2) % n]];
        if (!((b - a).cross(c - b).dot(up) > 0)) return true;
    }
    return false;
}

template <class Body>
void for_faces(std::size_t count, const Body& body) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1024), [&](const auto& range) {
        for (std::size_t f = range.begin(); f < range.end(); ++f) body(f);
    });
}

}  // namespace

Vec3 within(const Leeway& leeway, const Vec3& point) {
    Vec3 way = point - leeway.start;
    const double out = way.dot(leeway.ray);
    if (!leeway.ray.isZero(0)) way += (std::clamp(out, -leeway.in, leeway.out) - out) * leeway.ray;
    const double far = way.norm();
    return leeway.start + (far > leeway.far ? leeway.far / far : 1) * way;
}

Leeway leeway_of_ring(const Plain& skeleton, const Station& ring, std::int32_t sides, const Vec3& target) {
    const Vec3 from = (target - ring.centre) / ring_limit_radius(sides);
    const double radius = from.norm();
    Leeway leeway;
    if (!(radius > 0)) return leeway;
    leeway.start = ring.centre + from;
    leeway.ray = from / radius;
    leeway.out = leeway.in = most_aside * radius;
    if (ring.shape != RingShape::node || ring.before < 0 || ring.after < 0) return leeway;
    const Vec3 in = (ring.centre - skeleton.position[ring.before]).normalized(),
               out = (skeleton.position[ring.after] - ring.centre).normalized(), askew = out - in;
    if (askew.norm() < 1e-6) return leeway;  // straight: the mitre has no side
    const double cosine = std::sqrt(std::max(sharpest_mitre * sharpest_mitre, (1 + in.dot(out)) / 2)),
                 inward = leeway.ray.dot(askew.normalized());
    if (inward < 0) leeway.out += (1 / cosine - 1) * inward * inward * radius;
    return leeway;
}

PointGroups group_points(const Parts& parts, const Bridge& bridge) {
    const Stations& s = parts.stations;
    PointGroups groups{std::vector<std::int32_t>(bridge.mesh.vertex_count(), -1),
                       static_cast<std::int32_t>(s.stations.size())};
    for (std::int32_t p = 0; p < parts.network.path_count(); ++p)
        for (std::int32_t i = s.first[p]; i < s.first[p + 1]; ++i)
            std::fill_n(groups.of.begin() + first_of_ring(parts, bridge, p, i),
                        parts.refinement.path_sides[p], i);
    groups.count = groups.rings;
    for (std::int32_t& group : groups.of)
        if (group < 0) group = groups.count++;
    return groups;
}

void limit_by_edges(const QuadMesh& mesh, const PointGroups& groups, std::span<const char> limited,
                    std::span<Leeway> leeway) {
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        for (std::size_t i = 0; i < face.size(); ++i) {
            const std::uint32_t a = face[i], b = face[i + 1 < face.size() ? i + 1 : 0];
            const double length = (leeway[a].start - leeway[b].start).norm();
            for (const std::uint32_t v : {a, b}) {
                const bool of_ring = groups.of[v] < groups.rings;
                if (!limited[v] || (of_ring && groups.of[a] == groups.of[b])) continue;
                leeway[v].far = std::min(leeway[v].far, (of_ring ? most_of_column : most_of_edge) * length);
            }
        }
    }
}

void unfold(const QuadMesh& mesh, const PointGroups& groups, std::span<const Leeway> leeway,
            std::span<const std::uint32_t> moving, std::span<Vec3> control) {
    std::vector<Vec3> placed(control.size()), up(mesh.face_count());
    for (std::size_t v = 0; v < placed.size(); ++v) placed[v] = mesh.positions[v].cast<double>();
    std::vector<char> sound(mesh.face_count()), folds(mesh.face_count());
    for_faces(mesh.face_count(), [&](std::size_t f) {
        up[f] = normal_of(mesh.face(f), placed);
        sound[f] = !is_folded(mesh.face(f), placed, up[f]);
    });
    const std::vector<Vec3> full(control.begin(), control.end());
    std::vector<double> kept(groups.count, 1.0);   // of how far each group has moved
    std::vector<char> goes_back(groups.count, 1);  // a face none of whose groups went back is as it was
    for (int round = 1; round <= unfold_rounds; ++round) {
        for_faces(mesh.face_count(), [&](std::size_t f) {
            const auto face = mesh.face(f);
            folds[f] = 0;
            if (!sound[f] || std::none_of(face.begin(), face.end(),
                                          [&](std::uint32_t v) { return goes_back[groups.of[v]]; }))
                return;
            const Vec3 normal = normal_of(face, control);
            folds[f] = !(normal.dot(up[f]) > 0) || is_folded(face, control, normal);
        });
        std::fill(goes_back.begin(), goes_back.end(), 0);
        bool any = false;
        for (std::size_t f = 0; f < mesh.face_count(); ++f) {
            if (!folds[f]) continue;
            any = true;
            for (const std::uint32_t v : mesh.face(f)) goes_back[groups.of[v]] = 1;
        }
        if (!any) return;
        for (std::size_t g = 0; g < kept.size(); ++g)
            if (goes_back[g]) kept[g] = round < unfold_rounds ? back * kept[g] : 0;
        for (const std::uint32_t v : moving)
            control[v] = leeway[v].start + kept[groups.of[v]] * (full[v] - leeway[v].start);
    }
}

}  // namespace sinew::sqm
