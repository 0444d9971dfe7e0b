/// @file edits.h
/// The small changes that drawing is made of, as pure functions: document in, document out.
///
/// What comes in sound goes out sound: a tip that is no leaf any more becomes a sphere, a link that doubles a
/// bone goes. The larger operations (consolidate, merge, mirror, ...) are the library's, in
/// sinew/skeleton/edit.h.
#pragma once

#include <span>
#include <string>

#include "document/selection.h"
#include "sinew/skeleton/document.h"

namespace sinew::modeler {

/// A document and the nodes of it that the edit leaves selected.
struct Edited {
    Document document;
    Selection selection;
};

/// One node of radius 0.5 at the origin, mirrored at the plane x = 0.
Document starting_document();

/// Appends a node, keeping the side tables in step; returns its index. An id of -1 takes one that is free.
std::int32_t append_node(Document& document, Node node);

/// A new root at a place; selected.
Edited add_root(Document document, const Vec3& position, double radius);

/// A child of each node given, where its parent is (a drag moves them from there), as thick as its parent,
/// sections alike; a tip (cone, hemisphere, negative) moves on to the child. Children are selected, in the
/// order of their parents.
Edited add_children(Document document, std::span<const std::int32_t> parents);

/// A node on a bone (an index into bones_of), at the share `along` of it, its radius interpolated; selected.
Edited insert_on_bone(const Document& document, std::int32_t bone, double along);
/// One in the middle of each.
Edited insert_on_bones(Document document, std::span<const std::int32_t> bones);

/// Takes nodes out; what they joined stays joined (see dissolve in skeleton/edit.h), so that a deletion never
/// tears off a limb. The nearest ancestor that stays is selected.
Edited erase_nodes(const Document& document, const Selection& nodes);

/// Takes nodes and everything below them out.
Edited erase_branches(const Document& document, const Selection& nodes);

/// Copies with the bones and links among them; a copy whose parent is not copied is a child of that parent.
Edited duplicate(Document document, const Selection& nodes);

/// Joins or, where they are joined by a link, separates two nodes. Two trees become one by a parent, not a
/// link. Unchanged where a bone joins them already.
Document toggle_link(Document document, std::int32_t a, std::int32_t b);
bool are_joined(const Document& document, std::int32_t a, std::int32_t b);

/// True if `child` may become a child of `parent`: no cycle of parents.
bool may_reparent(const Document& document, std::int32_t child, std::int32_t parent);
/// Unchanged where may_reparent is false; parent -1 makes a root.
Document reparent(Document document, std::int32_t child, std::int32_t parent);

Document translate(Document document, std::span<const std::int32_t> nodes, const Vec3& by);
/// Radii, and extents of cubes, times a factor; kept between 1e-12 and 1e12.
Document scale_radii(Document document, std::span<const std::int32_t> nodes, double factor);
/// Types for leaves only are given to leaves only; the other nodes become spheres.
Document set_type(Document document, std::span<const std::int32_t> nodes, NodeType type);
Document rename(Document document, std::int32_t node, const std::string& name);

/// Sets one member of Node for all nodes given: `set(d, nodes, &Node::type, NodeType::cone)`.
template <class T>
Document set(Document document, std::span<const std::int32_t> nodes, T Node::*member, const T& value) {
    for (std::int32_t node : nodes) document.nodes[node].*member = value;
    return document;
}

}  // namespace sinew::modeler
