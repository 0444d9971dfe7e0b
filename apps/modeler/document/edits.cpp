#include "document/edits.h"

#include <algorithm>
#include <map>

#include "sinew/skeleton/edit.h"
#include "sinew/skeleton/graph.h"
#include "sinew/skeleton/rewire.h"

namespace sinew::modeler {
namespace {

const double smallest_length = 1e-12, largest_length = 1e12;

/// Drops links that double a bone, and makes spheres of tips that are no leaves any more: so that whatever one
/// does to a sound document leaves a sound one.
void tidy(Document& document) {
    std::erase_if(document.links, [&](const auto& link) {
        return link[0] == link[1] || document.nodes[link[0]].parent == link[1] ||
               document.nodes[link[1]].parent == link[0];
    });
    round_off_inner_tips(document);
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

std::int32_t append_node(Document& document, Node node) {
    if (node.id < 0) node.id = FreshIds(document).next();
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
        if (is_tip(document.nodes[parent].type)) child.type = document.nodes[parent].type;
        children.push_back(append_node(document, child));
    }
    tidy(document);
    return {std::move(document), selection_of(children)};
}

Edited insert_on_bone(const Document& document, std::int32_t bone, double along) {
    Result<Document> inserted = sinew::insert_on_bone(document, bone, along);
    if (!inserted) return {document, {}};
    const auto last = static_cast<std::int32_t>(inserted->nodes.size()) - 1;
    return {std::move(*inserted), selection_of(last)};
}

Edited insert_on_bones(Document document, std::span<const std::int32_t> bones) {
    // Inserting moves the other bones in their list, but not the nodes at their ends.
    std::vector<Bone> ends;
    for (std::int32_t bone : bones) ends.push_back(bones_of(document)[bone]);
    std::vector<std::int32_t> fresh;
    for (const Bone& pair : ends) {
        const std::vector<Bone> now = bones_of(document);
        const auto place = std::find(now.begin(), now.end(), pair);
        if (place == now.end()) continue;
        Edited edit = modeler::insert_on_bone(document, static_cast<std::int32_t>(place - now.begin()), 0.5);
        document = std::move(edit.document);
        fresh.push_back(edit.selection.active);
    }
    return {std::move(document), selection_of(fresh)};
}

Edited erase_nodes(const Document& document, const Selection& nodes) {
    if (nodes.empty()) return {document, {}};
    // What is left of a limb is selected, so that one can go on deleting towards the root.
    std::int32_t next = nodes.active;
    while (next >= 0 && nodes.contains(next)) next = document.nodes[next].parent;
    Document rest = dissolve(document, nodes.nodes);
    Selection selection = next < 0 ? Selection{} : carried(document, selection_of(next), rest);
    return {std::move(rest), std::move(selection)};
}

Edited erase_branches(const Document& document, const Selection& nodes) {
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
        node.radius = std::clamp(node.radius * factor, smallest_length, largest_length);
        if (node.size) *node.size = (*node.size * factor).cwiseMax(smallest_length).cwiseMin(largest_length);
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
