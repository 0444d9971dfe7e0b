/// @file condition.h
/// From a skeleton as drawn or measured to a clean graph that the mesher can take.
///
/// Always: bones of no length are merged, duplicate bones and self loops vanish. With `repair` (measured
/// skeletons) also: balls nested in a neighbour's, or almost at its centre, are merged into it, and runs of
/// nodes far closer than a radius are thinned, since a tube cannot turn within its own radius. Components and
/// independent cycles stay as many as they were, but for bones of no length and duplicates. Near-linear.
/// Positions and radii of kept nodes are not changed.
#pragma once

#include <cstdint>
#include <vector>

#include "sinew/base/result.h"
#include "sinew/skeleton/document.h"
#include "sinew/skeleton/graph.h"

namespace sinew {

/// The figures are of the 150 smallest skeletons of ../shared/data/graph, of which 46 have faces that cross
/// each other as the defaults are.
struct ConditionOptions {
    bool repair = false;
    /// A ball that reaches no further than this many radii of its neighbour's is merged into it. What is lost
    /// stands out by 2 %, about what a tube of four sides is out of round (1.4 %, docs/subdivision.md). From
    /// 1 to 1.2 it is the same 46.
    double nested = 1.02;
    /// So is one closer than this many radii (of the larger ball), where more than two bones meet. Without it
    /// there are 47; from 0.1 to 0.4 nothing changes: it is in the middle.
    double together = 0.2;
    /// Least distance along a run of nodes, as a multiple of the larger radius. Without it there are 55, with
    /// 0.3 50, with 0.45 47; 1 would leave 43, and take three times as many vertices away as 0.6 does.
    double spacing = 0.6;
};

/// A graph of balls and bones; every bone joins two different places, no two bones the same two nodes.
struct CleanGraph {
    std::vector<Vec3> position;
    std::vector<double> radius;
    std::vector<Bone> bones;
    std::vector<std::int32_t> source_node;  ///< index in Document::nodes
    std::vector<std::int32_t>
        source_bone;    ///< index in bones_of(document): the bone, or the first of the run it stands for
    Warnings warnings;  ///< what was merged and thinned, one a kind
};

CleanGraph condition(const Document& document, const ConditionOptions& options = {});

}  // namespace sinew
