#include "document/operation.h"

#include <algorithm>

#include "document/snap.h"
#include "sinew/skeleton/edit.h"
#include "sinew/skeleton/graph.h"
#include "sinew/skeleton/symmetry.h"

namespace sinew::modeler {
namespace {

using Values = std::span<const double>;
using Kind = Parameter::Kind;

const double longest = 1e9;

double mean_radius(const Document& document, const std::vector<std::int32_t>& nodes) {
    double sum = 0;
    for (std::int32_t i : nodes) sum += document.nodes[i].radius;
    return nodes.empty() ? 1 : sum / static_cast<double>(nodes.size());
}

Parameter axis(int start) { return {"Axis", "", Kind::choice, double(start), 0, 2, {"X", "Y", "Z"}}; }

}  // namespace

std::vector<double> values_of(const Operation& operation) {
    std::vector<double> values;
    for (const Parameter& parameter : operation.parameters) values.push_back(parameter.value);
    return values;
}

Operation consolidating(Document document, const Selection& selection) {
    std::vector<std::int32_t> chosen;
    for (std::int32_t leaf : leaves_of(document))
        if (selection.contains(leaf)) chosen.push_back(leaf);
    const Consolidation usual;
    return {"Consolidate leaves",
            {{"Distance", "Of the new node from the leaf, in radii of the leaf", Kind::factor, usual.distance,
              0.05, 20},
             {"Thickness", "Radius of the new node: 0 as the leaf's, 1 as its neighbour's", Kind::factor,
              usual.radius_share, 0, 1}},
            [document = std::move(document), chosen = std::move(chosen)](Values v) -> Result<Document> {
                return consolidate_leaves(document, {.distance = v[0], .radius_share = v[1]}, chosen);
            },
            "There is no leaf to consolidate"};
}

Operation merging(Document document, const Selection& selection) {
    std::vector<std::array<std::int32_t, 2>> pairs;
    for (std::size_t i = 1; i < selection.nodes.size(); ++i)
        pairs.push_back({selection.nodes[i - 1], selection.nodes[i]});
    return {"Merge",
            {},
            [document = std::move(document), pairs = std::move(pairs)](Values) {
                return merge_nodes(document, pairs);
            },
            "Select the nodes to merge"};
}

Operation merging_close_leaves(Document document) {
    const double start = 2 * mean_radius(document, leaves_of(document));
    return {"Merge close leaves",
            {{"Distance", "Leaves no farther apart become one", Kind::length, start, 0, longest}},
            [document = std::move(document)](Values v) {
                return merge_nodes(document, close_leaves(document, v[0]));
            },
            "No two leaves are so close: raise the distance, or select what is to be merged"};
}

Operation rerooting(Document document, std::int32_t node) {
    return {
        "Re-root",
        {},
        [document = std::move(document), node](Values) -> Result<Document> { return reroot(document, node); },
        "This node is a root already"};
}

Operation mirroring(Document document) {
    const bool mirrored = document.symmetry.kind == Symmetry::Kind::mirror;
    return {"Mirror copy",
            {axis(mirrored ? document.symmetry.axis : 0)},
            [document = std::move(document)](Values v) -> Result<Document> {
                return mirror(document, static_cast<int>(v[0]));
            },
            "The mirror image is there already"};
}

Operation copying_round(Document document) {
    return {"Radial copy",
            {axis(2), {"Images", "How many there will be, the first included", Kind::count, 6, 1, 1000}},
            [document = std::move(document)](Values v) -> Result<Document> {
                return radial_copy(document, static_cast<int>(v[0]), static_cast<int>(v[1]));
            },
            "Everything lies on the axis"};
}

Operation snapping_to_grid(Document document, const Selection& selection) {
    const double start = round_above(mean_radius(document, selection.nodes) / 2);
    return {"Snap to grid",
            {{"Step", "Distance of the grid's lines", Kind::length, start, 1e-6, longest}},
            [document = std::move(document), nodes = selection.nodes](Values v) -> Result<Document> {
                return snap_to_grid(document, v[0], nodes);
            },
            "All of it is on the grid already"};
}

Operation snapping_to_angles(Document document, const Selection& selection) {
    return {"Snap to angles",
            {{"Angle",
              "Bones turn to multiples of it",
              Kind::choice,
              1,
              0,
              4,
              {"5°", "15°", "30°", "45°", "90°"}}},
            [document = std::move(document), nodes = selection.nodes](Values v) {
                constexpr double degrees[] = {5, 15, 30, 45, 90};
                return snap_to_angle(document, degrees[static_cast<int>(v[0])], nodes);
            },
            "All angles are round already"};
}

Operation making_symmetry_real(Document document) {
    return {"Make symmetry real",
            {},
            [document = std::move(document)](Values) -> Result<Document> {
                return expand_symmetry(document).document;
            },
            "There is no symmetry"};
}

}  // namespace sinew::modeler
