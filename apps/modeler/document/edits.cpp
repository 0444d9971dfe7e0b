#include "document/edits.h"

#include <algorithm>
#include <map>

#include "sinew/skeleton/graph.h"

namespace sinew::modeler {
namespace {

const double smallest_radius = 1e-6;

std::vector<std::int32_t> degrees_of(const Document& document) {
    std::vector<std::int32_t> degrees(document.nodes.size(), 0);
    for (const Bone& bone : bones_of(document))
        for (std::int32_t node : bone) ++degrees[node];
    return degrees;
}

/// Keeps the nodes that `new_index` gives a place, and with them names, extras and links.
void keep(Document& document, const std::vector<std::int32_t>& new_index) {
    Document old = std::move(document);
    document = {};
    document.unit = old.unit;
    document.symmetry = old.symmetry;
    document.extra = old.extra;
    for (std::size_t i = 0; i < old.nodes.size(); ++i) {
        if (new_index[i] < 0) continue;
        document.nodes.push_back(old.nodes[i]);
        if (!old.names.empty()) document.names.push_back(old.names[i]);
        if (!old.extras.empty()) document.extras.push_back(old.extras[i]);
    }
    for (Node& node : document.nodes)
        if (node.parent >= 0) node.parent = new_index[node.parent];
    for (auto [a, b] : old.links)
        if (new_index[a] >= 0 && new_index[b] >= 0) document.links.push_back({new_index[a], new_index[b]});
}

std::vector<std::int32_t> places_without(const Document& document, const Selection& gone) {
    std::vector<std::int32_t> places(document.nodes.size());
    std::int32_t next = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
        places[i] = gone.contains(static_cast<std::int32_t>(i)) ? -1 : next++;
    return places;
}

bool for_leaves_only(NodeType type) {
    return type == NodeType::cone || type == NodeType::hemisphere || type == NodeType::negative;
}

/// Drops links that double a bone, and makes spheres of tips that are no leaves any more: so that whatever
/// one does to a sound document leaves a sound one.
void tidy(Document& document) {
    std::erase_if(document.links, [&](const auto& link) {
        return link[0] == link[1] || document.nodes[link[0]].parent == link[1] ||
               document.nodes[link[1]].parent == link[0];
    });
    const std::vector<std::int32_t> degrees = degrees_of(document);
    for (std::size_t i = 0; i < degrees.size(); ++i)
        if (for_leaves_only(document.nodes[i].type) && degrees[i] != 1)
            document.nodes[i].type = NodeType::sphere;
}

std::int32_t root_of(const Document& document, std::int32_t node) {
    while (document.nodes[node].parent >= 0) node = document.nodes[node].parent;
    return node;
}

/// What a node passes on to one that is drawn out of it.
Node descendant_of(const Node& from) {
    Node node;
    node.position = from.position;
    node.radius = from.radius;
    node.section = from.section;
    node.scale = {from.scale[0], from.scale[1], 1};
    node.roll = from.roll;
    return node;
}

}  // namespace

Document starting_document() {
    Document document;
    document.unit.assign(1, 'm');
    document.symmetry = {Symmetry::Kind::mirror, 0, 1};
    document.nodes.push_back({.radius = 0.5});
    return document;
}

std::int64_t unused_id(const Document& document) {
    std::int64_t id = 0;
    for (const Node& node : document.nodes) id = std::max(id, node.id + 1);
    return id;
}

std::int32_t append_node(Document& document, Node node) {
    if (node.id < 0) node.id = unused_id(document);
    document.nodes.push_back(node);
    if (!document.names.empty()) document.names.emplace_back();
    if (!document.extras.empty()) document.extras.emplace_back();
    return static_cast<std::int32_t>(document.nodes.size()) - 1;
}

Edited add_root(Document document, const Vec3& position, double radius) {
    std::int32_t node = append_node(document, {.id = -1, .position = position, .radius = radius});
    return {std::move(document), selection_of(node)};
}

Edited add_children(Document document, std::span<const std::int32_t> parents) {
    std::vector<std::int32_t> children;
    for (std::int32_t parent : parents) {
        Node child = descendant_of(document.nodes[parent]);
        child.id = -1;
        child.parent = parent;
        if (for_leaves_only(document.nodes[parent].type)) child.type = document.nodes[parent].type;
        children.push_back(append_node(document, child));
    }
    tidy(document);
    return {std::move(document), selection_of(children)};
}

Edited insert_on_bone(Document document, std::int32_t bone, double along) {
    const auto [first, second] = bones_of(document)[bone];
    const Node &a = document.nodes[first], &b = document.nodes[second];
    Node node = descendant_of(a);
    node.id = -1;
    node.position = (1 - along) * a.position + along * b.position;
    node.radius = (1 - along) * a.radius + along * b.radius;
    node.section = a.section == b.section ? a.section : Section::round;
    for (int i = 0; i < 2; ++i) node.scale[i] = (1 - along) * a.scale[i] + along * b.scale[i];
    node.parent = first;
    const std::int32_t middle = append_node(document, node);
    const std::int32_t bones_to_parents =
        static_cast<std::int32_t>(bones_of(document).size() - document.links.size()) - 1;
    if (bone < bones_to_parents)
        document.nodes[second].parent = middle;
    else
        document.links[bone - bones_to_parents] = {middle, second};
    return {std::move(document), selection_of(middle)};
}

namespace {

/// For each node its nearest ancestor that stays. Where none does, the first child of the lost root takes its
/// place.
std::vector<std::int32_t> heirs_without(const Document& document, const Selection& gone) {
    std::vector<std::int32_t> heirs(document.nodes.size());
    std::map<std::int32_t, std::int32_t> new_root;
    for (std::int32_t i = 0; i < std::ssize(document.nodes); ++i) {
        std::int32_t lost = -1, parent = document.nodes[i].parent;
        while (parent >= 0 && gone.contains(parent)) {
            lost = parent;
            parent = document.nodes[parent].parent;
        }
        heirs[i] = parent;
        if (parent >= 0 || lost < 0 || gone.contains(i)) continue;
        const auto [root, first] = new_root.emplace(lost, i);
        if (!first) heirs[i] = root->second;
    }
    return heirs;
}

}  // namespace

Edited erase_nodes(Document document, const Selection& nodes) {
    const std::vector<std::int32_t> heirs = heirs_without(document, nodes);
    Selection next;
    if (nodes.active >= 0 && heirs[nodes.active] >= 0) next = selection_of(heirs[nodes.active]);
    for (std::size_t i = 0; i < heirs.size(); ++i) document.nodes[i].parent = heirs[i];
    const std::vector<std::int32_t> places = places_without(document, nodes);
    keep(document, places);
    tidy(document);
    return {std::move(document), remapped(next, places)};
}

Edited erase_branches(Document document, const Selection& nodes) {
    return erase_nodes(document, with_descendants(document, nodes));
}

Edited duplicate(Document document, const Selection& nodes) {
    std::map<std::int32_t, std::int32_t> copy_of;
    for (std::int32_t node : nodes.nodes) {
        Node copy = document.nodes[node];
        copy.id = -1;
        copy_of[node] = append_node(document, copy);
        if (!document.extras.empty()) document.extras.back() = document.extras[node];
    }
    for (auto [node, copy] : copy_of) {
        auto parent = copy_of.find(document.nodes[node].parent);
        if (parent != copy_of.end()) document.nodes[copy].parent = parent->second;
    }
    const std::size_t link_count = document.links.size();
    for (std::size_t i = 0; i < link_count; ++i) {
        const auto [a, b] = document.links[i];
        if (copy_of.count(a) && copy_of.count(b)) document.links.push_back({copy_of[a], copy_of[b]});
    }
    std::vector<std::int32_t> copies;
    for (auto [node, copy] : copy_of) copies.push_back(copy);
    tidy(document);
    Selection selection = selection_of(copies);
    if (nodes.active >= 0) selection.active = copy_of[nodes.active];
    return {std::move(document), selection};
}

bool are_joined(const Document& document, std::int32_t a, std::int32_t b) {
    if (document.nodes[a].parent == b || document.nodes[b].parent == a) return true;
    return std::any_of(document.links.begin(), document.links.end(),
                       [&](const auto& link) { return std::minmax(link[0], link[1]) == std::minmax(a, b); });
}

Document toggle_link(Document document, std::int32_t a, std::int32_t b) {
    if (a == b) return document;
    const auto cut = std::erase_if(
        document.links, [&](const auto& link) { return std::minmax(link[0], link[1]) == std::minmax(a, b); });
    if (cut > 0 || are_joined(document, a, b)) return document;
    if (root_of(document, b) == b && root_of(document, a) != b)
        document.nodes[b].parent = a;
    else if (root_of(document, a) == a && root_of(document, b) != a)
        document.nodes[a].parent = b;
    else
        document.links.push_back({a, b});
    tidy(document);
    return document;
}

bool may_reparent(const Document& document, std::int32_t child, std::int32_t parent) {
    for (std::int32_t above = parent; above >= 0; above = document.nodes[above].parent)
        if (above == child) return false;
    return true;
}

Document reparent(Document document, std::int32_t child, std::int32_t parent) {
    if (!may_reparent(document, child, parent)) return document;
    document.nodes[child].parent = parent;
    tidy(document);
    return document;
}

Document translate(Document document, std::span<const std::int32_t> nodes, const Vec3& by) {
    for (std::int32_t node : nodes) document.nodes[node].position += by;
    return document;
}

Document scale_radii(Document document, std::span<const std::int32_t> nodes, double factor) {
    for (std::int32_t i : nodes) {
        Node& node = document.nodes[i];
        node.radius = std::max(node.radius * factor, smallest_radius);
        if (node.size) *node.size = (*node.size * factor).cwiseMax(smallest_radius);
    }
    return document;
}

Document set_type(Document document, std::span<const std::int32_t> nodes, NodeType type) {
    for (std::int32_t node : nodes) document.nodes[node].type = type;
    tidy(document);
    return document;
}

Document rename(Document document, std::int32_t node, const std::string& name) {
    if (document.names.empty() && name.empty()) return document;
    document.names.resize(document.nodes.size());
    document.names[node] = name;
    return document;
}

}  // namespace sinew::modeler
