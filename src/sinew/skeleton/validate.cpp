#include "sinew/skeleton/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "sinew/skeleton/graph.h"

namespace sinew {
namespace {

/// Collects problems up to the limit.
class Finder {
  public:
    Finder(const Document& document, std::size_t limit) : document_(document), limit_(limit) {}

    bool full() const { return found_.size() >= limit_; }
    void at_node(std::int32_t node, const char* key, std::string message, std::string cure) {
        add(fmt::format("/nodes/{}{}{}", node, *key ? "/" : "", key), document_.nodes[node].id,
            std::move(message), std::move(cure));
    }
    void add(std::string path, std::optional<std::int64_t> node, std::string message, std::string cure) {
        if (full()) return;
        found_.push_back(
            {.message = std::move(message), .cure = std::move(cure), .path = std::move(path), .node = node});
    }
    std::vector<Error> take() { return std::move(found_); }

  private:
    const Document& document_;
    std::size_t limit_;
    std::vector<Error> found_;
};

bool fits(double length) { return std::abs(length) <= largest_length; }  // false for nan

std::int64_t id_of(const Document& document, std::int32_t node) { return document.nodes[node].id; }

bool exists(const Document& document, std::int32_t node) {
    return node >= 0 && node < std::ssize(document.nodes);
}

/// Bones at each node; what names no node is left out here and reported elsewhere.
struct Neighbours {
    std::vector<std::int32_t> degree;
    std::vector<std::int32_t> last;  ///< one neighbour, the only one where the degree is 1
};

Neighbours neighbours_in(const Document& document) {
    const std::size_t count = document.nodes.size();
    Neighbours result{std::vector<std::int32_t>(count, 0), std::vector<std::int32_t>(count, -1)};
    for (const Bone& bone : bones_of(document)) {
        if (!exists(document, bone[0]) || !exists(document, bone[1])) continue;
        for (int end : {0, 1}) {
            ++result.degree[bone[end]];
            result.last[bone[end]] = bone[1 - end];
        }
    }
    return result;
}

const char* word(NodeType type) {
    switch (type) {
        case NodeType::cone:
            return "cone";
        case NodeType::hemisphere:
            return "hemisphere";
        case NodeType::negative:
            return "negative";
        default:
            return "node";
    }
}

void check_numbers(const Document& document, std::int32_t i, Finder& finder) {
    const Node& node = document.nodes[i];
    auto all = [](std::span<const double> values, auto&& good) { return std::ranges::all_of(values, good); };
    auto positive = [](double x) { return x > 0 && fits(x); };
    auto at_least_zero = [](double x) { return x >= 0 && fits(x); };

    if (!all({node.position.data(), 3}, fits))
        finder.at_node(i, "position", "the position has a coordinate that is not a number of at most 1e30",
                       "give it three finite numbers");
    if (!positive(node.radius))
        finder.at_node(i, "radius", fmt::format("the radius must be above 0 and finite, not {}", node.radius),
                       "give the node a positive radius");
    if (!all(node.scale, positive))
        finder.at_node(i, "scale", "the factors of the scale must be above 0 and finite",
                       "give positive factors of the radius");
    if (node.size && !all({node.size->data(), 3}, at_least_zero))
        finder.at_node(i, "size", "the extents of the size must be 0 or more and finite",
                       "give three full extents");
    if (!std::isfinite(node.roll))
        finder.at_node(i, "roll", "the roll must be a finite number", "give degrees about the bone");
    if (node.rotation) {
        const double norm = node.rotation->coeffs().norm();
        if (!(norm > 1e-6 && norm < 1e6))
            finder.at_node(i, "rotation", "the rotation is not a quaternion that can be normalised",
                           "give [x, y, z, w] of length 1; [0, 0, 0, 1] does not rotate");
    }
    if (node.blend && !(*node.blend >= 0 && *node.blend <= largest_blend))
        finder.at_node(i, "blend", fmt::format("the blend must be from 0 to {}", largest_blend),
                       "give the radius of the rolling ball in radii of the node");
    if (!(node.joint >= 0))
        finder.at_node(i, "joint", "the sharpness of a joint must be 0 or more",
                       "say \"smooth\", \"sharp\" or a number from 0 to 10");
}

/// Who writes an id where an index belongs is told the index.
std::string cure_of_parent(const Document& document, std::int32_t parent) {
    const auto same_id = [&](const Node& node) { return node.id == parent; };
    const auto meant = std::ranges::find_if(document.nodes, same_id);
    if (meant == document.nodes.end()) return "name an existing node, or -1 for a root";
    return fmt::format("the node with the id {} is at index {}", parent, meant - document.nodes.begin());
}

void check_place(const Document& document, const Neighbours& around, std::int32_t i, Finder& finder) {
    const Node& node = document.nodes[i];
    if (node.id < 0)
        finder.at_node(i, "id", fmt::format("the id {} is negative", node.id), "number the nodes from 0 up");
    if (node.parent == i)
        finder.at_node(i, "parent", "the node is its own parent", "leave the parent out for a root");
    else if (node.parent != -1 && !exists(document, node.parent))
        finder.at_node(
            i, "parent",
            fmt::format("there is no parent {} for the node at index {}: a parent is an index into the "
                        "nodes, and there are {}",
                        node.parent, i, document.nodes.size()),
            cure_of_parent(document, node.parent));

    if (is_tip(node.type) && around.degree[i] != 1)
        finder.at_node(
            i, "type",
            fmt::format("a {} must be a leaf, and this node has {} bones", word(node.type), around.degree[i]),
            "make it a sphere, or add a leaf for it");
    else if (node.type == NodeType::negative && document.nodes[around.last[i]].type == NodeType::negative)
        finder.at_node(i, "type", "a negative presses into its neighbour, which is a negative too",
                       "make one of them a sphere");
}

void check_ids(const Document& document, Finder& finder) {
    std::vector<std::pair<std::int64_t, std::int32_t>> ids(document.nodes.size());
    for (std::int32_t i = 0; i < std::ssize(ids); ++i) ids[i] = {document.nodes[i].id, i};
    if (!std::ranges::is_sorted(ids)) std::ranges::sort(ids);
    for (std::size_t k = 1; k < ids.size() && !finder.full(); ++k)
        if (ids[k].first == ids[k - 1].first)
            finder.at_node(ids[k].second, "id", fmt::format("the id {} is used twice", ids[k].first),
                           "give every node an id of its own");
}

/// Each cycle of parents is reported once, at the first of its nodes that a walk from the lowest node meets.
void check_parent_cycles(const Document& document, Finder& finder) {
    std::vector<std::int32_t> walk(document.nodes.size(), -1);  // from which node's walk this one was met
    for (std::int32_t start = 0; start < std::ssize(walk); ++start) {
        std::int32_t i = start;
        while (exists(document, i) && walk[i] < 0) {
            walk[i] = start;
            i = document.nodes[i].parent;
        }
        if (exists(document, i) && walk[i] == start && document.nodes[i].parent != i)
            finder.at_node(i, "parent",
                           fmt::format("the node is its own ancestor, by way of its parent {}",
                                       id_of(document, document.nodes[i].parent)),
                           "break the cycle at one parent; close it with a link instead");
    }
}

void check_links(const Document& document, Finder& finder) {
    std::vector<std::pair<Bone, std::int32_t>> sorted;
    for (std::int32_t k = 0; k < std::ssize(document.links); ++k) {
        auto [a, b] = document.links[k];
        const auto path = [&] { return fmt::format("/links/{}", k); };
        if (!exists(document, a) || !exists(document, b)) {
            finder.add(
                path(), {},
                fmt::format("the link of {} and {} names a node that does not exist: its ends are indices "
                            "into the nodes, and there are {}",
                            a, b, document.nodes.size()),
                "name two existing nodes");
        } else if (a == b) {
            finder.add(path(), id_of(document, a), "the link joins the node to itself", "name two nodes");
        } else if (document.nodes[a].parent == b || document.nodes[b].parent == a) {
            finder.add(path(), id_of(document, a),
                       fmt::format("the link repeats the bone between {} and {}", id_of(document, a),
                                   id_of(document, b)),
                       "remove the link");
        } else {
            sorted.push_back({{std::min(a, b), std::max(a, b)}, k});
        }
    }
    if (!std::ranges::is_sorted(sorted)) std::ranges::sort(sorted);
    for (std::size_t k = 1; k < sorted.size(); ++k)
        if (sorted[k].first == sorted[k - 1].first)
            finder.add(fmt::format("/links/{}", sorted[k].second), id_of(document, sorted[k].first[0]),
                       fmt::format("the link between {} and {} is given twice",
                                   id_of(document, sorted[k].first[0]), id_of(document, sorted[k].first[1])),
                       "remove one of the two");
}

void check_symmetry(const Symmetry& symmetry, Finder& finder) {
    if (symmetry.kind == Symmetry::Kind::none) return;
    if (symmetry.axis < 0 || symmetry.axis > 2)
        finder.add("/symmetry", {}, "the axis of the symmetry is none of x, y, z", "name one of them");
    if (symmetry.kind == Symmetry::Kind::radial &&
        (symmetry.count < 2 || symmetry.count > largest_symmetry_count))
        finder.add("/symmetry/radial/count", {},
                   fmt::format("a radial symmetry has 2 to {} images, not {}", largest_symmetry_count,
                               symmetry.count),
                   "change the count, or leave the symmetry out");
}

void check_side_tables(const Document& document, Finder& finder) {
    auto fits_nodes = [&](const auto& table) {
        return table.empty() || table.size() == document.nodes.size();
    };
    if (!fits_nodes(document.names) || !fits_nodes(document.extras))
        finder.add("/nodes", {}, "the names or extras are not one a node",
                   "keep the side tables in step with the nodes");
}

}  // namespace

std::vector<Error> problems(const Document& document, std::size_t limit) {
    Finder finder(document, limit);
    const Neighbours around = neighbours_in(document);
    for (std::int32_t i = 0; i < std::ssize(document.nodes) && !finder.full(); ++i) {
        check_place(document, around, i, finder);
        check_numbers(document, i, finder);
    }
    check_ids(document, finder);
    check_parent_cycles(document, finder);
    check_links(document, finder);
    check_symmetry(document.symmetry, finder);
    check_side_tables(document, finder);
    return finder.take();
}

Result<void> validate(const Document& document) {
    std::vector<Error> first = problems(document, 1);
    if (!first.empty()) return fail(std::move(first.front()));
    return {};
}

}  // namespace sinew
