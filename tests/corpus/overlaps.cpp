/// Where do meshes run through themselves? Skins skeletons as the program does, and tells of each pair of
/// faces that intersect whether the skeleton asks for it.
///
/// usage: sinew_overlaps SKELETON ...      a JSON object a line
///
/// A pair is excused where two of the (conditioned) skeleton's round cones hold a place where the faces
/// cross, or a corner of theirs, and overlap there beside their common node: they have none, or the place is
/// outside its ball. Those that only a corner excuses are counted too ("faces_by_corner"). What is left,
/// "elsewhere", is the mesher's own. Folded quads, those with a corner that turns against the face, are
/// counted alike: where a corner of theirs, or their middle, is in such an overlap; where single precision
/// cannot resolve them; and elsewhere.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "sinew/io/skeleton_formats.h"
#include "sinew/mesh/box_tree.h"
#include "sinew/mesh/intersect.h"
#include "sinew/mesh/measure.h"
#include "sinew/mesh/triangulate.h"
#include "sinew/skeleton/condition.h"
#include "sinew/sqm/skin.h"

namespace sinew {
namespace {

constexpr double rounding = 1e-3;  // vertices that lie on a cone count as in it

/// The round cones of a clean graph, and which of them hold a place.
class Cones {
  public:
    explicit Cones(const CleanGraph& graph) : g_(graph), bones_(graph.bones) {
        std::vector<std::uint8_t> lone(g_.position.size(), 1);
        for (const Bone& bone : g_.bones) lone[bone[0]] = lone[bone[1]] = 0;
        for (std::int32_t i = 0; i < std::ssize(lone); ++i)
            if (lone[i]) bones_.push_back({i, i});  // a ball
        std::vector<Box> boxes;
        for (const Bone& bone : bones_) {
            Box box;
            for (const std::int32_t node : bone)
                for (const double side : {-1.0, 1.0})
                    box.extend(
                        Vec3f((g_.position[node] + Vec3::Constant(side * g_.radius[node])).cast<float>()));
            boxes.push_back(box);
        }
        tree_ = build_box_tree(boxes);
    }

    bool overlap_beside_a_node(const Vec3& place) const {
        std::vector<std::uint32_t> holding;
        if (!tree_.levels.empty()) collect(tree_.levels.size() - 1, 0, place, holding);
        for (std::size_t i = 1; i < holding.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                if (beside(bones_[holding[i]], bones_[holding[k]], place)) return true;
        return false;
    }

  private:
    void collect(std::size_t level, std::size_t node, const Vec3& place,
                 std::vector<std::uint32_t>& out) const {
        Box box;
        box.extend(Vec3f(place.cast<float>()));
        if (!tree_.levels[level][node].overlaps(box)) return;
        if (level == 0) {
            if (holds(bones_[tree_.items[node]], place)) out.push_back(tree_.items[node]);
            return;
        }
        for (std::size_t c = tree_.first_child(node); c < tree_.end_child(level, node); ++c)
            collect(level - 1, c, place, out);
    }
    bool holds(const Bone& bone, const Vec3& place) const {
        const Vec3 &a = g_.position[bone[0]], axis = g_.position[bone[1]] - a;
        const double ra = g_.radius[bone[0]], rb = g_.radius[bone[1]], length = axis.norm();
        if (length == 0) return (place - a).norm() <= ra * (1 + rounding);
        const double along = (place - a).dot(axis) / length;
        const double across = std::sqrt(std::max(0.0, (place - a).squaredNorm() - along * along));
        const double sine = std::clamp((ra - rb) / length, -1.0, 1.0);
        const double slope = std::abs(sine) < 1 ? sine / std::sqrt(1 - sine * sine) : sine * 1e9;
        const double share = std::clamp((along - across * slope) / length, 0.0, 1.0);
        return (place - a - share * axis).norm() <= (ra + share * (rb - ra)) * (1 + rounding);
    }
    bool beside(const Bone& a, const Bone& b, const Vec3& place) const {
        for (const std::int32_t node : a)
            if (node == b[0] || node == b[1]) return (place - g_.position[node]).norm() > g_.radius[node];
        return true;
    }

    const CleanGraph& g_;
    std::vector<Bone> bones_;
    BoxTree tree_;
};

/// Where the edges of one face go through the other: nothing where both lie in one plane.
void add_crossings(const QuadMesh& mesh, const Triangles& triangles, std::uint32_t face, std::uint32_t other,
                   std::vector<Vec3>& out) {
    const auto at = [&](std::uint32_t v) -> Vec3 { return mesh.positions[v].cast<double>(); };
    for (const Triangle& t : triangles.of(face))
        for (int k = 0; k < 3; ++k)
            for (const Triangle& u : triangles.of(other)) {
                const Vec3 p = at(t[k]), q = at(t[(k + 1) % 3]), a = at(u[0]), b = at(u[1]), c = at(u[2]);
                const auto volume = [](const Vec3& x, const Vec3& y, const Vec3& z) {
                    return x.cross(y).dot(z);
                };
                const double dp = volume(b - a, c - a, p - a), dq = volume(b - a, c - a, q - a);
                if (dp * dq > 0 || dp == dq) continue;
                const Vec3 x = p + dp / (dp - dq) * (q - p), n = (b - a).cross(c - a);
                const auto left = [&](const Vec3& from, const Vec3& to) {
                    return (to - from).cross(x - from).dot(n) >= -1e-9 * n.squaredNorm();
                };
                if (left(a, b) && left(b, c) && left(c, a)) out.push_back(x);
            }
}

/// Edges so short that single precision, this far from the origin, bends them at will.
bool is_rounded(const QuadMesh& mesh, std::uint32_t face) {
    const auto vertices = mesh.face(face);
    float shortest = std::numeric_limits<float>::max(), farthest = 0;
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        const Vec3f& p = mesh.positions[vertices[k]];
        shortest = std::min(shortest, (p - mesh.positions[vertices[(k + 1) % vertices.size()]]).norm());
        farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
    }
    return shortest < 64 * std::numeric_limits<float>::epsilon() * farthest;
}

struct Folded {
    int in_overlap = 0, rounded = 0, elsewhere = 0;
};

Folded find_folded(const QuadMesh& mesh, const Cones& cones) {
    Folded folded;
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
        if (mesh.face(f).size() != 4 || quad_quality(mesh, f) > 0) continue;
        bool in_overlap = false;
        Vec3 middle = Vec3::Zero();
        for (const std::uint32_t v : mesh.face(f)) {
            const Vec3 corner = mesh.positions[v].cast<double>();
            in_overlap |= cones.overlap_beside_a_node(corner);
            middle += corner / 4;
        }
        in_overlap |= cones.overlap_beside_a_node(middle);
        ++(in_overlap ? folded.in_overlap : is_rounded(mesh, f) ? folded.rounded : folded.elsewhere);
    }
    return folded;
}

std::string look_at(const std::string& file) {
    const auto read = read_skeleton(file);
    if (!read) return fmt::format(R"({{"file": "{}", "error": true}})", file);
    const auto skin = sinew::skin(read->document, {.repair = read->measured});
    if (!skin) return fmt::format(R"({{"file": "{}", "error": true}})", file);
    const CleanGraph graph = condition(read->document, {.repair = read->measured});
    const Cones cones(graph);
    const Triangles triangles = triangulate(skin->mesh);
    const auto pairs = find_self_intersections(skin->mesh).value();
    std::set<std::uint32_t> faces, by_corner, rounded, elsewhere;
    const auto overlap = [&](const Vec3& place) { return cones.overlap_beside_a_node(place); };
    const Folded folded = find_folded(skin->mesh, cones);
    std::size_t unexcused = 0;
    std::string places;
    for (const FacePair& pair : pairs) {
        std::vector<Vec3> at;
        add_crossings(skin->mesh, triangles, pair[0], pair[1], at);
        add_crossings(skin->mesh, triangles, pair[1], pair[0], at);
        faces.insert(pair.begin(), pair.end());
        if (std::any_of(at.begin(), at.end(), overlap)) continue;
        for (const std::uint32_t face : pair)
            for (const std::uint32_t v : skin->mesh.face(face))
                at.push_back(skin->mesh.positions[v].cast<double>());
        if (std::any_of(at.begin(), at.end(), overlap)) {
            by_corner.insert(pair.begin(), pair.end());
            continue;
        }
        if (is_rounded(skin->mesh, pair[0]) || is_rounded(skin->mesh, pair[1])) {
            rounded.insert(pair.begin(), pair.end());
            continue;
        }
        ++unexcused;
        elsewhere.insert(pair.begin(), pair.end());
        if (unexcused <= 8)
            places += fmt::format("{}[{}, {}, {:.6g}, {:.6g}, {:.6g}]", places.empty() ? "" : ", ", pair[0],
                                  pair[1], at[0].x(), at[0].y(), at[0].z());
    }
    return fmt::format(
        R"({{"file": "{}", "faces": {}, "pairs": {}, "crossing_faces": {}, "faces_by_corner": {}, "rounded_faces": {}, "pairs_elsewhere": {}, "faces_elsewhere": {}, "folded_in_overlap": {}, "folded_rounded": {}, "folded_elsewhere": {}, "places": [{}]}})",
        file, skin->mesh.face_count(), pairs.size(), faces.size(), by_corner.size(), rounded.size(),
        unexcused, elsewhere.size(), folded.in_overlap, folded.rounded, folded.elsewhere, places);
}

}  // namespace
}  // namespace sinew

int main(int count, char** names) {
    for (int i = 1; i < count; ++i) fmt::print("{}\n", sinew::look_at(names[i]));
}
