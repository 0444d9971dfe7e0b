/// @file builder.h
/// The plain skeleton while it grows, and what the extensions ask about the document.
#pragma once

#include <optional>

#include "sinew/extend/frames.h"
#include "sinew/extend/plain.h"
#include "sinew/skeleton/condition.h"
#include "sinew/skeleton/document.h"
#include "sinew/skeleton/graph.h"

namespace sinew {

/// Node i of the graph is plain node i until an extension adds more; bone b joins the plain nodes at its two
/// attachments.
class PlainBuilder {
  public:
    PlainBuilder(const Document& document, const CleanGraph& graph, Warnings& warnings);

    // What was drawn. Indices are those of the graph.
    std::int32_t node_count() const { return static_cast<std::int32_t>(graph_.position.size()); }
    const Node& drawn(std::int32_t i) const { return document_.nodes[graph_.source_node[i]]; }
    NodeType type(std::int32_t i) const { return drawn(i).type; }
    /// Also one whose bones were all repaired away.
    bool is_root(std::int32_t i) const { return drawn(i).parent < 0 || degree(i) == 0; }
    bool is_plain_ball(
        std::int32_t i) const;  ///< a round, unscaled, smooth sphere that nothing is special about
    bool is_pit(std::int32_t i) const;
    std::int32_t degree(std::int32_t i) const { return adjacency_.degree(i); }
    std::span<const std::int32_t> bones(std::int32_t i) const { return adjacency_.bones(i); }
    std::int32_t other(std::int32_t bone, std::int32_t i) const;
    const Vec3& position(std::int32_t i) const { return position_[i]; }
    double radius(std::int32_t i) const { return graph_.radius[i]; }
    Vec3 direction(std::int32_t from, std::int32_t to) const;  ///< unit

    /// The bone to the parent, or the first one of a root.
    std::int32_t first_bone(std::int32_t i) const;
    /// Whether the first of two neighbours hangs from the second.
    bool is_below(std::int32_t i, std::int32_t above) const {
        return drawn(i).parent == graph_.source_node[above];
    }
    Frame frame(std::int32_t i) const;  ///< the node's, as skeleton/frames.h has it

    // The plain skeleton.
    std::int32_t add_node(const Vec3& position, double radius, std::int32_t of);
    void add_bone(std::int32_t a, std::int32_t b, BoneKind kind);  ///< one that nobody drew
    void set_form(std::int32_t node, const Form& form);
    const Form* form(std::int32_t node) const { return plain_.form(node); }
    void set_cap(std::int32_t node, Cap cap) { plain_.cap[node] = cap; }
    void set_radius(std::int32_t node, double radius) { plain_.radius[node] = radius; }
    void set_pit(std::int32_t node, double depth) {
        plain_.cap[node] = Cap::pit, plain_.pit_depth[node] = depth;
    }
    void move(std::int32_t node, const Vec3& position) { plain_.position[node] = position; }
    /// Where a bone of the graph is tied to at its end at node i.
    void attach(std::int32_t bone, std::int32_t i, std::int32_t plain_node);
    /// What a bone of the graph is; a tube unless told.
    void set_kind(std::int32_t bone, BoneKind kind) { attached_kind_[bone] = kind; }
    void warn(std::int32_t i, std::string_view what);

    Plain finish();

  private:
    void part_coincident();

    const Document& document_;
    const CleanGraph& graph_;
    Warnings& warnings_;
    Adjacency adjacency_;
    std::vector<Vec3> position_;  // as drawn, but for nodes at distance zero, which are a hair apart
    Plain plain_;
    std::vector<Bone> attached_;
    std::vector<BoneKind> attached_kind_;
};

}  // namespace sinew
