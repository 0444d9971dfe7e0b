#include "property/hostile_skeletons.h"

#include <algorithm>
#include <cmath>

#include "property/random.h"
#include "sinew/skeleton/graph.h"

namespace sinew::property {
namespace {

/// How the nodes of a skeleton lie and how their radii differ; one of each for a whole skeleton, so that what
/// is awkward meets more of its kind.
struct Manner {
    int radii, places, bones;
    Vec3 line;
};

double some_radius(Random& r, const Manner& manner) {
    switch (manner.radii) {
        case 0:
            return std::pow(10, r.between(-4, 4));
        case 1:
            return r.chance(0.5) ? 1e-4 : 1;
        case 2:
            return r.between(0.5, 3);  // larger than most bones are long
        default:
            return r.between(0.05, 0.3);
    }
}

Vec3 some_place(Random& r, const Manner& manner, const Document& document) {
    const auto& nodes = document.nodes;
    const Node& near = nodes[r.below(static_cast<int>(nodes.size()))];
    switch (manner.places) {
        case 0:
            return r.in_cube(3);
        case 1:
            return r.between(-3, 3) * manner.line;
        case 2:  // nearly on the same ray
            return near.position + r.between(0.1, 3) * (manner.line + 1e-7 * r.direction()).normalized();
        case 3:  // inside another one
            return near.position + r.unit() * near.radius * r.direction();
        case 4:
            return r.chance(0.3) ? near.position : Vec3(near.position + r.in_cube(1));
        default:
            return {double(r.whole(-2, 2)), double(r.whole(-2, 2)), double(r.whole(-2, 2))};
    }
}

void some_bones(Random& r, const Manner& manner, Document& document) {
    const auto count = static_cast<int>(document.nodes.size());
    auto& links = document.links;
    for (int i = 1; i < count; ++i) links.push_back({manner.bones == 0 ? 0 : r.below(i), i});
    const int more = manner.bones == 2 ? count * count / 4 : r.below(3);
    for (int k = 0; k < more; ++k)
        if (const int a = r.below(count), b = r.below(count); a != b)
            links.push_back({std::min(a, b), std::max(a, b)});
    std::sort(links.begin(), links.end());
    links.erase(std::unique(links.begin(), links.end()), links.end());
}

void some_types(Random& r, Document& document) {
    const Adjacency around = adjacency(static_cast<std::int32_t>(document.nodes.size()), bones_of(document));
    for (std::int32_t i = 0; i < std::ssize(document.nodes); ++i) {
        Node& node = document.nodes[i];
        if (r.chance(0.4)) continue;
        node.type = static_cast<NodeType>(r.below(6));
        const bool for_leaves = node.type == NodeType::cone || node.type == NodeType::hemisphere ||
                                node.type == NodeType::negative;
        if (for_leaves && around.degree(i) != 1) node.type = NodeType::sphere;
        if (r.chance(0.2)) node.section = Section::rectangular;
        if (r.chance(0.2)) node.scale = {r.between(0.1, 5), r.between(0.1, 5), r.between(0.1, 5)};
        if (r.chance(0.2)) node.joint = r.chance(0.5) ? infinitely_sharp : r.between(0, 4);
        if (node.type == NodeType::cube && r.chance(0.5))
            node.size = node.radius * Vec3(r.between(0, 20), r.between(0, 20), r.between(0, 20));
    }
    for (const auto& [a, b] : bones_of(document))  // a dent is pressed into something that is there
        if (document.nodes[a].type == NodeType::negative && document.nodes[b].type == NodeType::negative)
            document.nodes[b].type = NodeType::sphere;
}

}  // namespace

Case hostile_case(std::uint64_t seed) {
    Random r(seed);
    const Manner manner{r.below(4), r.below(6), r.below(3), r.direction()};
    Case made;
    made.kind = "hostile";
    Document& document = made.document;
    const bool symmetric = r.chance(0.4), radial = symmetric && r.chance(0.6);
    const int count = r.whole(2, radial ? 6 : 14);
    for (int i = 0; i < count; ++i) {
        Node node;
        node.id = i;
        node.radius = some_radius(r, manner);
        node.position = i == 0 ? Vec3(Vec3::Zero()) : some_place(r, manner, document);
        document.nodes.push_back(node);
    }
    some_bones(r, manner, document);
    if (r.chance(0.5)) some_types(r, document);
    if (symmetric)
        document.symmetry = {radial ? Symmetry::Kind::radial : Symmetry::Kind::mirror, r.below(3),
                             radial ? r.whole(2, 40) : 2};
    if (r.chance(0.2)) made.options.sides = r.whole(4, 12);
    if (r.chance(0.2)) made.options.fit = Fit::limit;
    made.options.repair = r.chance(0.2);
    return made;
}

}  // namespace sinew::property
