#include "sinew/skeleton/edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

#include "sinew/skeleton/frames.h"
#include "sinew/skeleton/graph.h"
#include "sinew/skeleton/rewire.h"
#include "sinew/skeleton/symmetry.h"

namespace sinew {
namespace {

std::int32_t node_count(const Document& document) { return static_cast<std::int32_t>(document.nodes.size()); }

std::vector<char> marks(const Document& document, std::span<const std::int32_t> nodes) {
    std::vector<char> marked(document.nodes.size(), nodes.empty());
    for (std::int32_t node : nodes) marked[node] = 1;
    return marked;
}

/// A node between two others, which is neither's child yet.
Node between(const Node& a, const Node& b, double along) {
    auto mixed = [&](double x, double y) { return x + (y - x) * along; };
    Node node{.position = a.position + (b.position - a.position) * along,
              .radius = mixed(a.radius, b.radius)};
    node.section = a.section == b.section ? a.section : Section::round;
    node.roll = a.roll == b.roll ? a.roll : 0;
    for (int k = 0; k < 2; ++k) node.scale[k] = mixed(a.scale[k], b.scale[k]);
    return node;
}

std::int32_t append(Document& document, Node node, std::int64_t id) {
    node.id = id;
    document.nodes.push_back(node);
    for (std::vector<std::string>* table : {&document.names, &document.extras})
        if (!table->empty()) table->emplace_back();
    return node_count(document) - 1;
}

/// Puts a node on the bone to a node's parent or, for child = -1, on a link.
std::int32_t split(Document& document, std::int32_t child, std::size_t link, Node node, std::int64_t id) {
    node.parent = child >= 0 ? document.nodes[child].parent : document.links[link][0];
    const std::int32_t added = append(document, node, id);
    (child >= 0 ? document.nodes[child].parent : document.links[link][0]) = added;
    return added;
}

/// Bones follow their nodes, and nodes that went elsewhere are dropped.
void collapse(Document& document, const std::vector<std::int32_t>& target) {
    std::vector<Bone> bones = bones_of(document);
    for (Bone& bone : bones) bone = {target[bone[0]], target[bone[1]]};
    std::erase_if(bones, [](const Bone& bone) { return bone[0] < 0 || bone[1] < 0; });
    set_bones(document, bones);
    std::vector<char> gone(target.size());
    for (std::int32_t i = 0; i < std::ssize(target); ++i) gone[i] = target[i] != i;
    drop_nodes(document, gone);
    round_off_inner_tips(document);
}

/// Nodes, parents before children.
std::vector<std::int32_t> parents_first(const Document& document) {
    std::vector<std::int32_t> order, way;
    std::vector<char> seen(document.nodes.size(), 0);
    for (std::int32_t i = 0; i < node_count(document); ++i) {
        for (std::int32_t k = i; k >= 0 && !std::exchange(seen[k], 1); k = document.nodes[k].parent)
            way.push_back(k);
        order.insert(order.end(), way.rbegin(), way.rend());
        way.clear();
    }
    return order;
}

/// For each node that goes, the one that takes its bones: the nearest ancestor that stays or else, for the
/// nodes below a root that goes, the first node that stays below it; -1 where there is none. Nodes that stay
/// are their own.
std::vector<std::int32_t> heirs(const Document& document, const std::vector<char>& gone) {
    const std::vector<std::int32_t> order = parents_first(document);
    std::vector<std::int32_t> heir(gone.size(), -1),
        top(gone.size(), -1);  // top: the lost root of a lost part
    for (std::int32_t i : order) {
        const std::int32_t parent = document.nodes[i].parent;
        if (!gone[i])
            heir[i] = i;
        else if (parent >= 0)
            heir[i] = heir[parent];
        if (gone[i] && heir[i] < 0) top[i] = parent < 0 ? i : top[parent];
    }
    std::vector<std::int32_t> first(gone.size(), -1);
    for (std::int32_t i : order) {
        const std::int32_t parent = document.nodes[i].parent;
        if (gone[i] || parent < 0 || top[parent] < 0) continue;
        std::int32_t& chosen = first[top[parent]];
        if (chosen < 0 || i < chosen) chosen = i;
    }
    for (std::int32_t i : order)
        if (top[i] >= 0) heir[i] = first[top[i]];
    return heir;
}

Document expanded(Document document, const Symmetry& symmetry) {
    document = expand_symmetry(document).document;
    document.symmetry = symmetry;
    return expand_symmetry(document).document;
}

}  // namespace

Result<std::int32_t> node_with_id(const Document& document, std::int64_t id) {
    const auto found = std::ranges::find(document.nodes, id, &Node::id);
    if (found == document.nodes.end())
        return fail(ErrorKind::call, fmt::format("there is no node {}", id),
                    "name the id of an existing node");
    return static_cast<std::int32_t>(found - document.nodes.begin());
}

Document consolidate_leaves(const Document& document, const Consolidation& how,
                            std::span<const std::int32_t> nodes) {
    Document result = document;
    const std::vector<Bone> bones = bones_of(document);
    const Adjacency around = adjacency(node_count(document), bones);
    const std::vector<char> chosen = marks(document, nodes);
    const std::size_t tree_bones = bones.size() - document.links.size();
    FreshIds ids(document);
    for (std::int32_t i = 0; i < node_count(document); ++i) {
        if (!chosen[i] || around.degree(i) != 1 || document.nodes[i].type == NodeType::negative) continue;
        const std::int32_t b = around.bones(i)[0], other = bones[b][0] == i ? bones[b][1] : bones[b][0];
        const Node &leaf = document.nodes[i], &neighbour = document.nodes[other];
        const double length = (neighbour.position - leaf.position).norm();
        if (!(length > 0)) continue;
        const double along = std::min(how.distance * leaf.radius / length, 0.4);
        Node node = between(leaf, neighbour, along);
        node.radius = leaf.radius + (neighbour.radius - leaf.radius) * how.radius_share;
        // The other end may have been a leaf too, with a new node already: then this one goes between that
        // and the leaf.
        const bool to_parent = static_cast<std::size_t>(b) < tree_bones;
        const bool leaf_is_child = to_parent && document.nodes[i].parent == other;
        if (leaf_is_child) {
            split(result, i, 0, node, ids.next());
        } else if (to_parent) {
            node.parent = i;
            const std::int32_t added = append(result, node, ids.next());
            std::int32_t child = other;
            while (result.nodes[child].parent != i) child = result.nodes[child].parent;
            result.nodes[child].parent = added;
        } else {
            const std::size_t link = b - tree_bones;
            const int end = result.links[link][0] == i ? 0 : 1;
            node.parent = i;
            result.links[link][end] = append(result, node, ids.next());
        }
    }
    return result;
}

Result<Document> merge_nodes(const Document& document, std::span<const std::array<std::int32_t, 2>> pairs) {
    std::vector<std::int32_t> above(document.nodes.size());
    std::iota(above.begin(), above.end(), 0);
    auto top = [&](std::int32_t i) {
        while (above[i] != i) i = above[i] = above[above[i]];
        return i;
    };
    for (const auto& [a, b] : pairs) {
        for (std::int32_t node : {a, b})
            if (node < 0 || node >= node_count(document))
                return fail(ErrorKind::call, fmt::format("there is no node at index {}", node),
                            "name existing nodes");
        if (a == b)
            return fail(ErrorKind::call,
                        fmt::format("the node {} cannot be merged with itself", document.nodes[a].id),
                        "name two nodes");
        above[std::max(top(a), top(b))] = std::min(top(a), top(b));
    }
    Document result = document;
    std::vector<double> members(document.nodes.size(), 0);
    std::vector<std::int32_t> target(document.nodes.size());
    for (std::int32_t i = 0; i < node_count(document); ++i) {
        target[i] = top(i);
        const double n = ++members[target[i]];  // running means: exact where all are alike
        Node& node = result.nodes[target[i]];
        node.position += (document.nodes[i].position - node.position) / n;
        node.radius += (document.nodes[i].radius - node.radius) / n;
    }
    collapse(result, target);
    return result;
}

std::vector<std::array<std::int32_t, 2>> close_leaves(const Document& document, double distance) {
    std::vector<std::int32_t> leaves = leaves_of(document);
    const auto x = [&](std::int32_t i) { return document.nodes[i].position.x(); };
    std::ranges::stable_sort(leaves, {}, x);

    std::vector<std::tuple<double, std::int32_t, std::int32_t>> near;
    for (std::size_t i = 0; i < leaves.size(); ++i)
        for (std::size_t k = i + 1; k < leaves.size() && x(leaves[k]) - x(leaves[i]) <= distance; ++k) {
            const double apart =
                (document.nodes[leaves[i]].position - document.nodes[leaves[k]].position).norm();
            if (apart <= distance)
                near.emplace_back(apart, std::min(leaves[i], leaves[k]), std::max(leaves[i], leaves[k]));
        }
    std::ranges::sort(near);
    std::vector<char> taken(document.nodes.size(), 0);
    std::vector<std::array<std::int32_t, 2>> pairs;
    for (const auto& [apart, a, b] : near) {
        if (taken[a] || taken[b]) continue;
        taken[a] = taken[b] = 1;
        pairs.push_back({a, b});
    }
    return pairs;
}

Result<Document> insert_on_bone(const Document& document, std::int32_t bone, double along) {
    const std::vector<Bone> bones = bones_of(document);
    if (bone < 0 || bone >= std::ssize(bones))
        return fail(ErrorKind::call, fmt::format("there is no bone {}", bone), "name the child at its end");
    if (!(along >= 0 && along <= 1))
        return fail(ErrorKind::call, fmt::format("{} is no share of a bone", along),
                    "give a number from 0 to 1");
    Document result = document;
    const auto& [a, b] = bones[bone];
    const Node node = between(document.nodes[a], document.nodes[b], along);
    const std::size_t tree_bones = bones.size() - document.links.size();
    const bool is_link = static_cast<std::size_t>(bone) >= tree_bones;
    split(result, is_link ? -1 : b, is_link ? bone - tree_bones : 0, node, FreshIds(document).next());
    return result;
}

Document dissolve(const Document& document, std::span<const std::int32_t> nodes) {
    if (nodes.empty()) return document;
    Document result = document;
    collapse(result, heirs(document, marks(document, nodes)));
    return result;
}

Document reroot(const Document& document, std::int32_t node) {
    Document result = document;
    std::vector<std::int32_t> way;
    for (std::int32_t i = node; i >= 0; i = document.nodes[i].parent) way.push_back(i);
    for (std::size_t k = 1; k < way.size(); ++k) result.nodes[way[k]].parent = way[k - 1];
    result.nodes[node].parent = -1;

    const std::vector<Bone> old_bones = bones_of(document), bones = bones_of(result);
    const Adjacency old_around = adjacency(node_count(document), old_bones),
                    around = adjacency(node_count(result), bones);
    for (std::int32_t i : way) {
        if (way.size() == 1 || !has_axes(document, old_bones, old_around, i)) continue;
        turn_to(result, bones, around, i, local_frame(document, old_bones, old_around, i),
                document.nodes[i].roll);
    }
    return result;
}

Document mirror(const Document& document, int axis) {
    return expanded(document, {Symmetry::Kind::mirror, axis, 1});
}

Document radial_copy(const Document& document, int axis, int count) {
    return expanded(document, {count > 1 ? Symmetry::Kind::radial : Symmetry::Kind::none, axis, count});
}

Document snap_to_grid(const Document& document, double step, std::span<const std::int32_t> nodes) {
    Document result = document;
    const std::vector<char> chosen = marks(document, nodes);
    for (std::int32_t i = 0; i < node_count(document); ++i)
        if (chosen[i])
            for (double& x : result.nodes[i].position) x = std::round(x / step) * step + 0.0;
    return result;
}

Result<Document> snap_to_angle(const Document& document, double degrees,
                               std::span<const std::int32_t> nodes) {
    const double count = std::round(360 / degrees);
    if (!(count >= 1 && count <= 1e6 && std::abs(count * degrees - 360) < 1e-9))
        return fail(ErrorKind::call, fmt::format("a full turn is no multiple of {} degrees", degrees),
                    "give 90, 45, 30, 15 ...");
    Document result = document;
    const std::vector<char> chosen = marks(document, nodes);
    // The first column of the turn by the nearest multiple: its cosine and sine.
    const Symmetry turns{Symmetry::Kind::radial, 2, static_cast<int>(count)};
    auto snapped = [&](double y, double x) -> Vec3 {
        const double turn = std::atan2(y, x) / (2 * std::numbers::pi);
        return symmetry_transform(turns, static_cast<int>(std::round(turn * count))).col(0);
    };
    for (std::int32_t i : parents_first(document)) {
        const std::int32_t parent = document.nodes[i].parent;
        if (parent < 0) continue;
        Vec3 bone = document.nodes[i].position - document.nodes[parent].position;
        if (chosen[i]) {
            const Vec3 around = snapped(bone.y(), bone.x()),
                       up = snapped(bone.z(), Vec2(bone.x(), bone.y()).norm());
            bone = bone.norm() * Vec3(up.x() * around.x(), up.x() * around.y(), up.y());
        }
        result.nodes[i].position = result.nodes[parent].position + bone;
    }
    return result;
}

}  // namespace sinew
