#include "property/random_skeletons.h"

#include <algorithm>

#include "property/random_kinds.h"
#include "sinew/skeleton/graph.h"

namespace sinew::property {
namespace {

/// Turns some leaves into cones. A mirrored skeleton keeps its twins alike by a rule that does not depend on
/// the node.
void some_cones(Random& random, Document& document) {
    const Adjacency around = adjacency(static_cast<std::int32_t>(document.nodes.size()), bones_of(document));
    const bool all = random.chance(0.3);
    for (std::int32_t i = 0; i < std::ssize(document.nodes); ++i)
        if (around.degree(i) == 1 && (all || document.nodes[i].radius < 0.15))
            document.nodes[i].type = NodeType::cone;
}

/// Types, sections, scales, sharpness and rotations, all mixed.
void some_types(Random& random, Document& document) {
    const Adjacency around = adjacency(static_cast<std::int32_t>(document.nodes.size()), bones_of(document));
    const double share = random.between(0.1, 1);
    const NodeType only = static_cast<NodeType>(random.below(6));
    const bool one_type = random.chance(0.4);
    for (std::int32_t i = 0; i < std::ssize(document.nodes); ++i) {
        Node& node = document.nodes[i];
        if (!random.chance(share)) continue;
        node.type = one_type ? only : static_cast<NodeType>(random.below(6));
        const bool for_leaves = node.type == NodeType::cone || node.type == NodeType::hemisphere ||
                                node.type == NodeType::negative;
        if (for_leaves && around.degree(i) != 1) node.type = NodeType::sphere;
        if (random.chance(0.3)) node.section = Section::rectangular;
        if (random.chance(0.3))
            node.scale = {random.between(0.3, 2), random.between(0.3, 2), random.between(0.3, 2)};
        if (random.chance(0.3)) node.joint = random.chance(0.5) ? infinitely_sharp : random.between(0, 4);
        if (random.chance(0.3)) node.roll = random.between(-180, 180);
        if (random.chance(0.3))
            node.rotation = Quat(Eigen::AngleAxisd(random.between(-3, 3), random.direction()));
        if (node.type == NodeType::cube && random.chance(0.6))
            node.size = node.radius * Vec3(random.between(0, 6), random.between(0, 6), random.between(0, 6));
    }
    // A pit is pressed into something that is there.
    for (const auto& [a, b] : bones_of(document))
        if (document.nodes[a].type == NodeType::negative && document.nodes[b].type == NodeType::negative)
            document.nodes[b].type = NodeType::sphere;
}

/// Every bone once, in any order and direction.
void sort_bones_out(Random& random, Document& document) {
    auto& links = document.links;
    for (auto& [a, b] : links)
        if (a > b) std::swap(a, b);
    std::sort(links.begin(), links.end());
    links.erase(std::unique(links.begin(), links.end()), links.end());
    for (int i = static_cast<int>(links.size()) - 1; i > 0; --i)
        std::swap(links[i], links[random.below(i + 1)]);
    for (auto& [a, b] : links)
        if (random.chance(0.5)) std::swap(a, b);
}

/// Gives the bones of a tree that spans the graph to its nodes as their parents.
void use_parents(Random& random, Document& document) {
    const auto count = static_cast<std::int32_t>(document.nodes.size());
    const std::vector<std::int32_t> roots{random.below(count)};
    const SpanningForest forest = spanning_forest(count, document.links, roots);
    std::vector<std::array<std::int32_t, 2>> rest;
    for (const std::int32_t b : forest.rest)
        if (document.links[b][0] != document.links[b][1]) rest.push_back(document.links[b]);
    document.links = std::move(rest);
    for (std::int32_t i = 0; i < count; ++i) document.nodes[i].parent = forest.parent[i];
}

}  // namespace

Case random_case(std::uint64_t seed) {
    Random random(seed);
    Case made;
    made.kind = draw_random_kind(random, seed, made.document);
    if (made.kind != "refused") sort_bones_out(random, made.document);
    if (random.chance(0.25))
        some_cones(random, made.document);
    else if (random.chance(0.4)) {
        some_types(random, made.document);
        made.kind += " of types";
    }
    if (random.chance(0.5)) use_parents(random, made.document);
    if (random.chance(0.4)) made.options.sides = random.whole(4, 12);
    made.options.repair = random.chance(0.4);
    if (random.chance(0.3)) made.options.fit = Fit::limit;
    return made;
}

}  // namespace sinew::property
