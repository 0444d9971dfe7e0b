/// @file graph.h
/// The bones of a document as a graph: who is whose neighbour, in flat arrays.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sinew/skeleton/document.h"

namespace sinew {

using Bone = std::array<std::int32_t, 2>;

/// All bones of a document: first those to the parents, in the order of the nodes, then the links.
std::vector<Bone> bones_of(const Document& document);

/// Bones round each node (compressed rows): those of node i are incident[first[i] .. first[i + 1]).
struct Adjacency {
    std::vector<std::int32_t> first;     ///< nodes + 1 entries
    std::vector<std::int32_t> incident;  ///< bone indices, in ascending order for each node

    std::span<const std::int32_t> bones(std::int32_t node) const {
        return {incident.data() + first[node], incident.data() + first[node + 1]};
    }
    std::int32_t degree(std::int32_t node) const { return first[node + 1] - first[node]; }
};
Adjacency adjacency(std::int32_t node_count, std::span<const Bone> bones);
/// That of bones_of.
Adjacency adjacency(const Document& document);

/// Nodes with one bone, ascending.
std::vector<std::int32_t> leaves_of(const Document& document);

/// Number of connected components and of independent cycles (bones - nodes + components).
struct GraphCounts {
    std::int64_t components = 0;
    std::int64_t cycles = 0;
};
GraphCounts count_graph(std::int32_t node_count, std::span<const Bone> bones);

/// Trees that span a graph, one a component.
struct SpanningForest {
    std::vector<std::int32_t> parent;  ///< of each node; -1 for roots
    std::vector<std::int32_t> rest;    ///< bones that no tree uses, ascending: each closes a cycle
};
/// Breadth first from each of `roots` in their order, then from the lowest node that was not reached yet.
SpanningForest spanning_forest(std::int32_t node_count, std::span<const Bone> bones,
                               std::span<const std::int32_t> roots = {});

}  // namespace sinew
