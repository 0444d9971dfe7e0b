#include "property/properties.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <utility>

#include "property/arrangement.h"
#include "property/same_shape.h"
#include "sinew/extend/extend.h"
#include "sinew/mesh/measure.h"
#include "sinew/mesh/validate.h"
#include "sinew/skeleton/graph.h"
#include "sinew/skeleton/symmetry.h"
#include "sinew/skeleton/validate.h"

namespace sinew::property {
namespace {

/// Components and cycles once bones of no length are merged and duplicates dropped: all that conditioning may
/// change of them.
GraphCounts expected_counts(const Document& drawn) {
    const Document document =
        drawn.symmetry.kind == Symmetry::Kind::none ? drawn : expand_symmetry(drawn).document;
    const auto is_ball = [](const Node& n) {  // others are drawn at distance zero on purpose
        return n.type == NodeType::sphere && n.section == Section::round;
    };
    const std::vector<Bone> bones = bones_of(document);
    std::vector<std::int32_t> parent(document.nodes.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](std::int32_t i) {
        while (parent[i] != i) i = parent[i];
        return i;
    };
    std::int64_t merged = 0;
    for (const auto& [a, b] : bones) {
        const Node &u = document.nodes[a], &v = document.nodes[b];
        const bool together = (u.position - v.position).norm() <= 1e-9 * std::max(u.radius, v.radius);
        if (!together || root(a) == root(b) || !is_ball(u) || !is_ball(v)) continue;
        parent[root(a)] = root(b);
        ++merged;
    }
    std::vector<Bone> kept;
    for (const auto& [a, b] : bones)
        if (root(a) != root(b)) kept.push_back({std::min(root(a), root(b)), std::max(root(a), root(b))});
    std::sort(kept.begin(), kept.end());
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    GraphCounts counts = count_graph(static_cast<std::int32_t>(document.nodes.size()), kept);
    counts.components -= merged;
    return counts;
}

std::string topology(const Skin& skin, const GraphCounts& counts) {
    const Validation v = validate(skin.mesh);
    if (!v.finite()) return fmt::format("finite: {} vertices are not", v.non_finite.count);
    if (!v.closed()) return fmt::format("closed: {} boundary edges", v.boundary_edges.count);
    if (!v.manifold())
        return fmt::format("manifold: {} edges, {} vertices, {} faces are not", v.nonmanifold_edges.count,
                           v.nonmanifold_vertices.count, v.repeating_faces.count + v.small_faces.count);
    if (!v.oriented()) return fmt::format("oriented: {} edges are flipped", v.flipped_edges.count);
    if (v.loose_vertices) return fmt::format("loose: {} vertices", v.loose_vertices.count);
    if (v.components != counts.components)
        return fmt::format("components: {}, not {}", v.components, counts.components);
    const std::int64_t euler = 2 * counts.components - 2 * counts.cycles;
    if (v.euler != euler) return fmt::format("euler: {}, not {}", v.euler, euler);
    if (skin.components != counts.components || skin.cycles != counts.cycles)
        return "counts: the skin reports other components or cycles";
    if (!v.outward()) return fmt::format("outward: {} components are not", v.inward_components.count);
    return {};
}

std::string faces(const Skin& skin) {
    const QuadMesh& mesh = skin.mesh;
    std::vector<std::uint8_t> pole(mesh.vertex_count(), 0);
    for (const std::uint32_t p : mesh.features.poles) pole[p] = 1;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto face = mesh.face(f);
        const auto poles = std::count_if(face.begin(), face.end(), [&](auto v) { return pole[v]; });
        if (face.size() == 4 ? poles != 0 : face.size() != 3 || poles != 1)
            return fmt::format("faces: face {} has {} corners and {} poles", f, face.size(), poles);
    }
    const std::vector<std::uint32_t> valence = valences(build_topology(mesh));
    std::int64_t irregular = 0;
    std::uint32_t highest = 0;
    for (std::size_t v = 0; v < valence.size(); ++v) {
        irregular += valence[v] != 4;
        if (!pole[v]) highest = std::max(highest, valence[v]);
    }
    if (irregular > skin.irregular)
        return fmt::format("irregular: {} vertices, {} at most", irregular, skin.irregular);
    if (highest > 12) return fmt::format("valence: {}", highest);
    return {};
}

std::string origins(const Skin& skin, const Document& document) {
    const QuadMesh& mesh = skin.mesh;
    const auto bones = std::ssize(bones_of(document));
    if (mesh.vertex_node.size() != mesh.vertex_count() || mesh.vertex_bone.size() != mesh.vertex_count() ||
        mesh.vertex_along.size() != mesh.vertex_count())
        return "origins: not one a vertex";
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
        if (mesh.vertex_node[v] < 0 || mesh.vertex_node[v] >= std::ssize(document.nodes) ||
            mesh.vertex_bone[v] < -1 || mesh.vertex_bone[v] >= bones ||
            !(mesh.vertex_along[v] >= 0 && mesh.vertex_along[v] <= 1))
            return fmt::format("origins: vertex {}", v);
    return {};
}

/// A distance that rounding to single precision explains.
float rounding_of(const QuadMesh& mesh) {
    Vec3f low = mesh.positions[0], high = low;
    for (const Vec3f& p : mesh.positions) low = low.cwiseMin(p), high = high.cwiseMax(p);
    return 1e-4f * (high - low).norm() + 1e-6f * std::max(low.norm(), high.norm());
}

/// What subdivision must keep is there, and is so to begin with.
std::string features(const Case& tried, const QuadMesh& mesh) {
    const Topology topology = build_topology(mesh);
    const auto is_edge = [&](const MeshEdge& edge) { return find_edge(topology, edge) != no_index; };
    for (const Crease& crease : mesh.features.creases)
        if (!is_edge(crease.edge) || !(crease.sharpness > 0))
            return "features: a crease is no edge, or not sharp";
    for (const std::uint32_t corner : mesh.features.corners)
        if (corner >= mesh.vertex_count()) return "features: a corner is no vertex";
    const float near = rounding_of(mesh);
    const bool as_drawn = tried.options.fit == Fit::control;  // otherwise they hold of the smooth surface
    for (const Circle& circle : mesh.features.circles)
        for (const MeshEdge& edge : circle.edges) {
            if (!is_edge(edge)) return "features: the edge of a circle is none";
            const Vec3f from = mesh.positions[edge[0]] - circle.centre;
            if (as_drawn &&
                (std::abs(from.norm() - circle.radius) > near || std::abs(from.dot(circle.axis)) > near))
                return fmt::format("features: vertex {} is off its circle by {} and {}", edge[0],
                                   from.norm() - circle.radius, from.dot(circle.axis));
        }
    const auto& nodes = tried.document.nodes;
    const bool pressed =
        std::any_of(nodes.begin(), nodes.end(), [](const Node& n) { return n.type == NodeType::negative; });
    for (const Plane& plane : mesh.features.planes)
        for (const std::uint32_t face : plane.faces) {
            if (face >= mesh.face_count()) return "features: the face of a plane is none";
            for (const std::uint32_t v : mesh.face(face))
                if (as_drawn && !pressed &&
                    std::abs((mesh.positions[v] - plane.point).dot(plane.normal)) > near)
                    return fmt::format("features: vertex {} is not in its plane", v);
        }
    return {};
}

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}
bool same_bytes(const QuadMesh& a, const QuadMesh& b) {
    return same_bytes(a.positions, b.positions) && same_bytes(a.face_offsets, b.face_offsets) &&
           same_bytes(a.corners, b.corners) && same_bytes(a.vertex_node, b.vertex_node) &&
           same_bytes(a.vertex_bone, b.vertex_bone) && same_bytes(a.vertex_along, b.vertex_along) &&
           same_bytes(a.features.poles, b.features.poles);
}

/// Again, on one thread.
std::string repeatable(const Case& tried, const Skin& skin) {
    tbb::task_arena alone(1);
    return alone.execute([&]() -> std::string {
        const auto again = sinew::skin(tried.document, tried.options);
        return again && same_bytes(again->mesh, skin.mesh) ? "" : "repeatable: other bytes on one thread";
    });
}

/// What is left of zeros by rounding can be too small for single precision once it is scaled.
void drop_smallest(QuadMesh& mesh) {
    for (Vec3f& p : mesh.positions)
        for (float& x : p)
            if (std::abs(x) < 1e-28f) x = 0;
}

std::string scalable(const Case& tried, QuadMesh mesh) {
    Document scaled = tried.document;
    const double factor = tried.document.nodes.size() % 2 == 0 ? 0x1p-30 : 0x1p9;
    for (Node& node : scaled.nodes) {
        node.position *= factor;
        node.radius *= factor;
        if (node.size) *node.size *= factor;
    }
    auto result = sinew::skin(scaled, tried.options);
    if (!result) return "scalable: fails when scaled";
    for (Vec3f& p : result->mesh.positions) p *= static_cast<float>(1 / factor);
    drop_smallest(result->mesh);
    drop_smallest(mesh);
    return same_bytes(result->mesh, mesh) ? "" : "scalable: other bytes when scaled by a power of two";
}

/// Some skeletons have more than one answer, of which an image may get another one: an odd ring cannot be
/// symmetric in more than one plane, so that nothing but the axes of the world turns a tube from leaf to
/// leaf; and where directions are regular, triangles, twists and counts tie. Beside a ball a million times its
/// size no two places of a vertex can be told apart.
bool has_one_answer(const Case& tried) {
    for (const char* kind : {"lattice", "planar", "star", "closed", "hostile"})
        if (tried.kind == kind) return false;
    return is_plain(tried.document) && tried.options.sides % 2 == 0 && !tried.options.repair &&
           least_angle(tried.document) > 0.2;
}

std::string mirrors(const Case& tried, const Skin& skin) {
    if (!has_one_answer(tried)) return {};
    Document image = tried.document;
    for (Node& node : image.nodes) node.position.x() = -node.position.x();
    const auto result = sinew::skin(image, tried.options);
    if (!result) return "mirrors: fails when mirrored";
    const std::string difference = difference_of(moved(skin.mesh, mirror_of(0)), result->mesh, 2e-6);
    return difference.empty() ? "" : "mirrors: the mesh of the mirrored skeleton differs, " + difference;
}

/// To the last bit in the first plane that has anything beside it; up to rounding in others, in which odd
/// rings cannot be symmetric too. Not where bones leave a joint side by side, nor after repair, which may
/// keep one of two twins.
std::string symmetric(const Case& tried, const Skin& skin) {
    if (!is_plain(tried.document) || tried.options.repair || least_angle(tried.document) < 0.2) return {};
    bool exact = true;
    for (int axis = 0; axis < 3; ++axis) {
        if (!is_own_image(tried.document, axis)) continue;
        const bool to_the_bit = !is_flat(tried.document, axis) && std::exchange(exact, false);
        if (!to_the_bit && tried.options.sides % 2 != 0) continue;
        const std::string difference =
            difference_of(moved(skin.mesh, mirror_of(axis)), skin.mesh, to_the_bit ? 0 : 1e-6);
        if (!difference.empty())
            return fmt::format("symmetric: not its own image across axis {}{}, {}", axis,
                               to_the_bit ? " to the last bit" : "", difference);
    }
    return {};
}

/// Boxes and ellipses do not look alike after a third or a fifth of a turn, nor do the bones that carry what
/// is bare of a ball, nor a ball of quads alone: none of them may stand on the axis. Where more than six
/// bones leave it alike, faces with a pole meet others of as many sides, and rounding decides.
bool may_turn(const Document& document) {
    const Symmetry& symmetry = document.symmetry;
    if (symmetry.kind != Symmetry::Kind::radial || symmetry.count == 2) return true;
    if (symmetry.count > 6) return false;
    const auto on_axis = [&](const Node& n) {
        const Vec3 along = n.position[symmetry.axis] * Vec3::Unit(symmetry.axis);
        return (n.position - along).norm() <= 1e-3 * n.radius;
    };
    const std::vector<Bone> bones = bones_of(document);
    const Adjacency around = adjacency(static_cast<std::int32_t>(document.nodes.size()), bones);
    return std::none_of(document.nodes.begin(), document.nodes.end(), [&](const Node& n) {
        const bool alone = around.degree(static_cast<std::int32_t>(&n - document.nodes.data())) == 0;
        const bool round = n.section == Section::round && n.scale[0] == n.scale[1];
        const auto self = static_cast<std::int32_t>(&n - document.nodes.data());
        const auto around_it = around.bones(self);
        const bool has_dents = std::any_of(around_it.begin(), around_it.end(), [&](std::int32_t b) {
            return document.nodes[bones[b][0] == self ? bones[b][1] : bones[b][0]].type == NodeType::negative;
        });
        const bool has_body =
            n.type == NodeType::cube || n.type == NodeType::ball || n.type == NodeType::negative || has_dents;
        return on_axis(n) && (!round || has_body || alone);
    });
}

/// A symmetry that was drawn holds: to the last bit where its turns are exact, or else up to rounding. Not
/// where bones leave a joint side by side, nor after repair, which may keep one of two twins.
std::string as_drawn(const Case& tried, const Skin& skin) {
    if (tried.document.symmetry.kind == Symmetry::Kind::none || tried.options.repair ||
        !may_turn(tried.document))
        return {};
    const ExpandedSymmetry whole = expand_symmetry(tried.document);
    Warnings warnings;
    const Plain plain = extend(whole.document, condition(whole.document), warnings);
    if (std::min(least_angle(whole.document), least_angle(plain)) < 0.2) return {};
    const bool exact = whole.order == 2 || whole.order == 4;
    const std::string difference =
        difference_of(moved(skin.mesh, whole.generator), skin.mesh, exact ? 0 : 1e-6);
    return difference.empty() ? "" : "drawn: the symmetry that was drawn does not hold, " + difference;
}

}  // namespace

std::string failure_of(const Case& tried) {
    const auto skin = sinew::skin(tried.document, tried.options);
    if (const auto valid = validate(tried.document); !valid) {
        if (skin) return "refused: skinned although validate() says " + valid.error().text();
        return skin.error().kind == ErrorKind::input ? "" : "refused: " + skin.error().text();
    }
    if (!skin) return "skin: " + skin.error().text();
    std::string failure = topology(*skin, expected_counts(tried.document));
    if (failure.empty()) failure = faces(*skin);
    if (failure.empty()) failure = origins(*skin, tried.document);
    if (failure.empty()) failure = features(tried, skin->mesh);
    if (failure.empty()) failure = repeatable(tried, *skin);
    if (failure.empty()) failure = scalable(tried, skin->mesh);
    if (failure.empty()) failure = symmetric(tried, *skin);
    if (failure.empty()) failure = as_drawn(tried, *skin);
    if (failure.empty()) failure = mirrors(tried, *skin);
    return failure;
}

std::string name_of(const std::string& failure) { return failure.substr(0, failure.find(':')); }

}  // namespace sinew::property
