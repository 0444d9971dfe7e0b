#include "cli/skeleton_report.h"

#include <fmt/format.h>

#include <algorithm>

#include "sinew/io/files.h"
#include "sinew/skeleton/validate.h"

namespace sinew::cli {
namespace {

constexpr std::size_t most_problems = 20;

RoundCones cones_of(const Document& document) {
    RoundCones cones;
    std::vector<bool> has_bone(document.nodes.size(), false);
    for (const Bone& bone : bones_of(document)) {
        const Node &a = document.nodes[bone[0]], &b = document.nodes[bone[1]];
        cones.add(a.position, a.radius, b.position, b.radius);
        has_bone[bone[0]] = has_bone[bone[1]] = true;
    }
    for (std::size_t i = 0; i < document.nodes.size(); ++i)
        if (const Node& node = document.nodes[i]; !has_bone[i])
            cones.add(node.position, node.radius, node.position, node.radius);
    return cones;
}

bool is_plain(const Document& document) {
    const std::array<double, 3> round{1, 1, 1};
    return document.symmetry.kind == Symmetry::Kind::none &&
           std::all_of(document.nodes.begin(), document.nodes.end(), [&](const Node& node) {
               return (node.type == NodeType::sphere || node.type == NodeType::cone) &&
                      node.section == Section::round && node.scale == round;
           });
}

void count_degrees(const CleanGraph& graph, SkeletonFacts& facts) {
    const auto nodes = static_cast<std::int32_t>(graph.position.size());
    const Adjacency neighbours = adjacency(nodes, graph.bones);
    for (std::int32_t node = 0; node < nodes; ++node) {
        const std::int64_t degree = neighbours.degree(node);
        facts.leaves += degree == 1;
        facts.branches += degree > 2;
        facts.largest_degree = std::max(facts.largest_degree, degree);
        facts.irregular += degree == 0 ? 8 : degree == 1 ? 1 : 2 * (degree - 2);
    }
}

Json to_json(const SkeletonFacts& facts) {
    return {{"kind", "skeleton"},
            {"nodes", facts.nodes},
            {"bones", facts.bones},
            {"components", facts.components},
            {"cycles", facts.cycles},
            {"leaves", facts.leaves},
            {"branches", facts.branches},
            {"largest_degree", facts.largest_degree},
            {"least_radius", facts.least_radius},
            {"largest_radius", facts.largest_radius},
            {"irregular_at_most", facts.irregular}};
}

std::string to_text(const std::string& name, const SkeletonFacts& facts, std::int64_t nodes_read) {
    std::string text = fmt::format("{}: sound skeleton\n", name);
    const auto line = [&](std::string_view what, const std::string& value) {
        text += fmt::format("  {:<22}{}\n", what, value);
    };
    line("nodes", facts.nodes == nodes_read
                      ? fmt::format("{}", nodes_read)
                      : fmt::format("{}, {} after conditioning", nodes_read, facts.nodes));
    line("bones", fmt::format("{}", facts.bones));
    line("components, cycles", fmt::format("{}, {}", facts.components, facts.cycles));
    line("leaves, branches", fmt::format("{}, {}", facts.leaves, facts.branches));
    line("largest degree", fmt::format("{}", facts.largest_degree));
    line("radii", fmt::format("{:.6g} to {:.6g}", facts.least_radius, facts.largest_radius));
    if (facts.plain) line("irregular, at most", fmt::format("{}", facts.irregular));
    return text;
}

/// All that is wrong, the first on the status's account, the others as further lines.
Result<Outcome> refuse(const std::string& name, const std::vector<Error>& wrong) {
    Outcome outcome{.good = false};
    Json list = Json::array();
    for (Error error : wrong) {
        error.file = name;
        outcome.text += error.text() + "\n";
        list.push_back(cli::to_json(error));
    }
    outcome.json = {{"kind", "skeleton"}, {"problems", list}};
    return outcome;
}

}  // namespace

SkeletonFacts facts_of(const ReadSkeleton& read) {
    SkeletonFacts facts;
    const CleanGraph graph = condition(read.document, {.repair = read.measured});
    const GraphCounts counts = count_graph(static_cast<std::int32_t>(graph.position.size()), graph.bones);
    facts.nodes = std::ssize(graph.position);
    facts.bones = std::ssize(graph.bones);
    facts.components = counts.components;
    facts.cycles = counts.cycles;
    count_degrees(graph, facts);
    if (!graph.radius.empty()) {
        const auto [least, largest] = std::minmax_element(graph.radius.begin(), graph.radius.end());
        facts.least_radius = *least;
        facts.largest_radius = *largest;
    }
    facts.plain = is_plain(read.document);
    if (facts.plain) facts.cones = cones_of(read.document);
    facts.warnings = graph.warnings;
    return facts;
}

Result<Outcome> check_skeleton(Session& session, const Job& job, const FileOptions& files) {
    const auto read = read_input_skeleton(session, job, files, false);
    if (!read) return fail(read.error());
    if (const auto wrong = problems(read->document, most_problems); !wrong.empty())
        return refuse(input_name(job.input), wrong);

    const SkeletonFacts facts = facts_of(*read);
    if (const auto told = session.warn(job.input, facts.warnings); !told) return fail(told.error());
    return Outcome{.text = to_text(input_name(job.input), facts, std::ssize(read->document.nodes)),
                   .json = to_json(facts)};
}

}  // namespace sinew::cli
