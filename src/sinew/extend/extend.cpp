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
    for (std::size_t i = 0; i < plain.source_node.size(); ++i) {
        const Node& node = document.nodes[plain.source_node[i]];
        if (node.type != NodeType::sphere && node.type != NodeType::cone)
            return cannot_skin(node, fmt::format("a {}", name_of(node.type)));
        if (node.section != Section::round) return cannot_skin(node, "a rectangular section");
        if (node.scale != std::array<double, 3>{1, 1, 1}) return cannot_skin(node, "a scaled section");
        if (node.type == NodeType::cone) plain.cap[i] = Cap::point, plain.radius[i] = 0;
    }
    plain.symmetry = find_mirror(plain);
    return plain;
}

}  // namespace sinew
