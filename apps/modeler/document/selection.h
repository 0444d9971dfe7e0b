/// @file selection.h
/// Which nodes are chosen, and the ways of choosing more of them. Plain data and pure functions.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sinew/skeleton/document.h"

namespace sinew::modeler {

/// Nodes by index. The active one is the last that was picked: panels show it first, tools take their measure
/// from it.
struct Selection {
    std::vector<std::int32_t> nodes;  ///< ascending, each once
    std::int32_t active = -1;         ///< one of `nodes`, or -1 where there is none

    bool empty() const { return nodes.empty(); }
    bool contains(std::int32_t node) const;
    bool operator==(const Selection&) const = default;
};

/// The nodes given, in any order and with repeats; the last one becomes active.
Selection selection_of(std::span<const std::int32_t> nodes);
inline Selection selection_of(std::int32_t node) { return selection_of(std::span(&node, 1)); }

/// With the node added, or taken out where it was in.
Selection toggled(const Selection& selection, std::int32_t node);

/// Both together; the active node is the second's if it has one.
Selection united(const Selection& a, const Selection& b);

Selection all_nodes(const Document& document);
Selection inverted(const Document& document, const Selection& selection);

/// Everything that bones and links join to what is selected.
Selection linked(const Document& document, const Selection& selection);

/// What is selected and everything below it.
Selection with_descendants(const Document& document, const Selection& selection);

/// One step along the tree from the active node: its parent, its first child, its next sibling (round and
/// round). Unchanged where there is no such node.
enum class Step : std::uint8_t { parent, child, sibling };
Selection stepped(const Document& document, const Selection& selection, Step step);

/// The same nodes where `new_index[old]` says where each went (-1: gone).
Selection remapped(const Selection& selection, std::span<const std::int32_t> new_index);

/// The same nodes, found by their ids.
Selection carried(const Document& before, const Selection& selection, const Document& after);

}  // namespace sinew::modeler
