#include "sinew/extend/extend.h"

#include <fmt/format.h>

namespace sinew {
namespace {

std::string_view name_of(NodeType type) {
    constexpr std::string_view names[] = {"sphere", "cone", "hemisphere", "cube", "negative", "ball"};
    return names[static_cast<int>(type)];
}

tl::unexpected<Error> cannot_skin(const Node& node, std::string_view what) {
    return fail(Error{.kind = ErrorKind::input,
                      .message = fmt::format("this version cannot skin {}", what),
                      .cure = "leave it out, or draw the node as a sphere or a cone",
                      .node = node.id});
}

/// Two cones that look at each other have no tube to stand on: a ring of the mean of their radii goes
/// between.
void part_double_cones(const Document& document, Plain& plain) {
    const auto drawn = [&](std::int32_t i) { return document.nodes[plain.source_node[i]].radius; };
    const auto bones = static_cast<std::int32_t>(plain.bones.size());
    for (std::int32_t b = 0; b < bones; ++b) {
        const auto [from, to] = plain.bones[b];
        if (plain.cap[from] != Cap::point || plain.cap[to] != Cap::point) continue;
        const std::int32_t middle = plain.node_count();
        plain.position.push_back(0.5 * (plain.position[from] + plain.position[to]));
        plain.radius.push_back(0.5 * (drawn(from) + drawn(to)));
        plain.cap.push_back(Cap::round);
        plain.source_node.push_back(plain.source_node[from]);
        plain.bones[b][1] = middle;
        plain.bones.push_back({middle, to});
        plain.source_bone.push_back(plain.source_bone[b]);
    }
}

}  // namespace

Result<Plain> extend(const Document& document, CleanGraph&& graph) {
    if (document.symmetry.kind != Symmetry::Kind::none)
        return fail(ErrorKind::input, "this version cannot skin a document with a symmetry",
                    "draw both sides");
    Plain plain;
    plain.position = std::move(graph.position);
    plain.radius = std::move(graph.radius);
    plain.bones = std::move(graph.bones);
    plain.source_node = std::move(graph.source_node);
    plain.source_bone = std::move(graph.source_bone);
    plain.cap.assign(plain.position.size(), Cap::round);
    const Adjacency around = adjacency(plain.node_count(), plain.bones);
    for (std::size_t i = 0; i < plain.source_node.size(); ++i) {
        const Node& node = document.nodes[plain.source_node[i]];
        if (node.type != NodeType::sphere && node.type != NodeType::cone)
            return cannot_skin(node, fmt::format("a {}", name_of(node.type)));
        if (node.section != Section::round) return cannot_skin(node, "a rectangular section");
        if (node.scale != std::array<double, 3>{1, 1, 1}) return cannot_skin(node, "a scaled section");
        // Conditioning may have merged a cone into what it stood on: it is no leaf any more, but a ball.
        if (node.type == NodeType::cone && around.degree(static_cast<std::int32_t>(i)) == 1)
            plain.cap[i] = Cap::point, plain.radius[i] = 0;
    }
    part_double_cones(document, plain);
    plain.symmetry = find_mirror(plain);
    return plain;
}

}  // namespace sinew
