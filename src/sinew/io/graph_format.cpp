#include "sinew/io/graph_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <iterator>

#include "sinew/io/field_reader.h"
#include "sinew/io/measured.h"
#include "sinew/io/plain_document.h"
#include "sinew/skeleton/graph.h"

namespace sinew {
namespace {

struct GraphLines {
    Document document;
    std::vector<std::int64_t> node_lines;
    std::vector<std::array<std::int64_t, 2>> bones;  ///< as in the file
    std::vector<std::int64_t> bone_lines;
};

Result<void> read_node(FieldReader& fields, GraphLines& graph) {
    Node node;
    node.id = std::ssize(graph.document.nodes);
    for (int axis = 0; axis < 3; ++axis) {
        const Result<double> coordinate = fields.number(std::string_view("xyz").substr(axis, 1));
        if (!coordinate) return fail(coordinate.error());
        node.position[axis] = *coordinate;
    }
    const Result<double> radius = fields.number("radius");
    if (!radius) return fail(radius.error());
    node.radius = *radius;
    graph.document.nodes.push_back(node);
    graph.node_lines.push_back(fields.line());
    return {};
}

Result<void> read_bone(FieldReader& fields, GraphLines& graph) {
    std::array<std::int64_t, 2> ends{};
    for (int end : {0, 1}) {
        const Result<std::int64_t> node = fields.integer(end == 0 ? "first node" : "second node");
        if (!node) return fail(node.error());
        if (*node < 0)
            return fields.fail_here(fmt::format("there is no node {}", *node), "number the nodes from 0");
        ends[end] = *node;
    }
    graph.bones.push_back(ends);
    graph.bone_lines.push_back(fields.line());
    return {};
}

Result<GraphLines> read_lines(std::string_view text) {
    GraphLines graph;
    FieldReader fields(text);
    while (fields.next_line()) {
        const std::string_view kind = fields.next_field();
        if (kind != "n" && kind != "c")
            return fields.fail_here(fmt::format("a line must start with n, c or #, not with {}", shown(kind)),
                                    "write n x y z r for a node, c i j for a bone");
        const Result<void> read = kind == "n" ? read_node(fields, graph) : read_bone(fields, graph);
        if (!read) return fail(read.error());
    }
    if (graph.document.nodes.empty())
        return fail(ErrorKind::input, "the file has no nodes", "write n x y z r for each");
    return graph;
}

/// The bones that exist, join two nodes and were not given before.
Result<std::vector<Bone>> sound_bones(const GraphLines& graph, Remarks& remarks) {
    const std::int64_t count = std::ssize(graph.document.nodes);
    std::vector<std::pair<Bone, std::size_t>> sorted;  // with the lower node first
    sorted.reserve(graph.bones.size());
    for (std::size_t k = 0; k < graph.bones.size(); ++k) {
        const auto [low, high] = std::minmax(graph.bones[k][0], graph.bones[k][1]);
        if (high >= count)
            return fail(Error{
                .message = fmt::format("there is no node {}; the file has nodes 0 to {}", high, count - 1),
                .cure = "name an existing node or add it",
                .line = graph.bone_lines[k]});
        if (low == high)
            remarks.note("bone", "from a node to itself: dropped", low, graph.bone_lines[k]);
        else
            sorted.push_back({{static_cast<std::int32_t>(low), static_cast<std::int32_t>(high)}, k});
    }
    std::ranges::sort(sorted);
    std::vector<char> kept(graph.bones.size(), 0);
    for (std::size_t s = 0; s < sorted.size(); ++s) {
        const auto& [bone, k] = sorted[s];
        kept[k] = s == 0 || sorted[s - 1].first != bone;
        if (!kept[k]) remarks.note("bone", "given more than once: dropped", bone[0], graph.bone_lines[k]);
    }
    std::vector<Bone> bones;
    bones.reserve(sorted.size());
    for (std::size_t k = 0; k < graph.bones.size(); ++k)
        if (kept[k])
            bones.push_back(
                {static_cast<std::int32_t>(graph.bones[k][0]), static_cast<std::int32_t>(graph.bones[k][1])});
    return bones;
}

void set_bones(Document& document, std::span<const Bone> bones) {
    const SpanningForest forest = spanning_forest(static_cast<std::int32_t>(document.nodes.size()), bones);
    for (std::size_t i = 0; i < document.nodes.size(); ++i) document.nodes[i].parent = forest.parent[i];
    for (std::int32_t b : forest.rest) document.links.push_back(bones[b]);
}

}  // namespace

Result<ReadSkeleton> parse_graph(std::string_view text, const ReadOptions& options) try {
    Result<GraphLines> graph = read_lines(text);
    if (!graph) return fail(std::move(graph.error()));
    Remarks remarks;
    const Result<std::vector<Bone>> bones = sound_bones(*graph, remarks);
    if (!bones) return fail(bones.error());
    set_bones(graph->document, *bones);
    repair_radii(graph->document, graph->node_lines, remarks);
    note_zero_lengths(graph->document, graph->node_lines, remarks);
    Result<Warnings> warnings = remarks.take(options.strict);
    if (!warnings) return fail(std::move(warnings.error()));
    return ReadSkeleton{std::move(graph->document), std::move(*warnings), true};
} catch (const std::exception& exception) {  // bad_alloc
    return fail(ErrorKind::program, fmt::format("the graph cannot be taken in ({})", exception.what()));
}

Result<WrittenSkeleton> print_graph(const Document& given) {
    Result<PlainDocument> plain = plain_document(given, "graph");
    if (!plain) return fail(std::move(plain.error()));
    const Document& document = plain->document;
    std::string text;
    auto out = std::back_inserter(text);
    for (const Node& node : document.nodes)
        fmt::format_to(out, "n {} {} {} {}\n", node.position.x(), node.position.y(), node.position.z(),
                       node.radius);
    for (const auto& [a, b] : bones_of(document)) fmt::format_to(out, "c {} {}\n", a, b);
    return WrittenSkeleton{std::move(text), std::move(plain->warnings)};
}

}  // namespace sinew
