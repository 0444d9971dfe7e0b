#include "sinew/io/measured.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

#include "sinew/skeleton/graph.h"

namespace sinew {
namespace {

double length_of(const Document& document, const Bone& bone) {
    return (document.nodes[bone[0]].position - document.nodes[bone[1]].position).norm();
}

/// For each node the nearest one with a positive radius; -1 where its component has none (Dijkstra from all
/// of them).
std::vector<std::int32_t> nearest_with_radius(const Document& document) {
    const std::vector<Bone> bones = bones_of(document);
    const auto count = static_cast<std::int32_t>(document.nodes.size());
    const Adjacency around = adjacency(count, bones);

    using Reach = std::pair<double, std::int32_t>;  // ties go to the lower node
    std::priority_queue<Reach, std::vector<Reach>, std::greater<>> queue;
    std::vector<std::int32_t> nearest(count, -1);
    std::vector<double> distance(count, std::numeric_limits<double>::infinity());
    for (std::int32_t i = 0; i < count; ++i) {
        if (!(document.nodes[i].radius > 0)) continue;
        nearest[i] = i;
        distance[i] = 0;
        queue.push({0, i});
    }
    while (!queue.empty()) {
        const auto [so_far, i] = queue.top();
        queue.pop();
        if (so_far > distance[i]) continue;  // met on a shorter way since: there is only time to lose
        for (std::int32_t b : around.bones(i)) {
            const std::int32_t next = bones[b][0] == i ? bones[b][1] : bones[b][0];
            const double there = so_far + length_of(document, bones[b]);
            if (there >= distance[next]) continue;
            distance[next] = there;
            nearest[next] = nearest[i];
            queue.push({there, next});
        }
    }
    return nearest;
}

std::int64_t line_at(std::span<const std::int64_t> lines, std::int32_t node) {
    return lines.empty() ? 0 : lines[node];
}

}  // namespace

void Remarks::note(std::string_view noun, std::string_view predicate, std::int64_t node, std::int64_t line) {
    auto kind = std::ranges::find_if(
        kinds_, [&](const Kind& k) { return k.noun == noun && k.predicate == predicate; });
    if (kind == kinds_.end()) {
        kinds_.push_back({.noun = std::string(noun), .predicate = std::string(predicate), .line = line});
        kind = kinds_.end() - 1;
    }
    ++kind->count;
    if (line > 0) kind->line = std::min(kind->line, line);
    if (node >= 0 && kind->nodes.size() < 16) kind->nodes.push_back(node);
}

std::string Remarks::text(const Kind& kind, bool with_line) {
    const std::string text =
        fmt::format("{} {}{} {}", kind.count, kind.noun, kind.count == 1 ? "" : "s", kind.predicate);
    if (!with_line || kind.line == 0) return text;
    return text + fmt::format(" ({}on line {})", kind.count == 1 ? "" : "the first ", kind.line);
}

Result<Warnings> Remarks::take(bool strict) const {
    Warnings warnings;
    for (const Kind& kind : kinds_) {
        if (strict) {
            Error error{.message = text(kind, false),
                        .cure = "correct the file, or read it without --strict",
                        .line = kind.line};
            if (!kind.nodes.empty()) error.node = kind.nodes.front();
            return fail(std::move(error));
        }
        warnings.push_back({.message = text(kind, true), .count = kind.count, .nodes = kind.nodes});
    }
    return warnings;
}

void repair_radii(Document& document, std::span<const std::int64_t> lines, Remarks& remarks) {
    if (std::ranges::all_of(document.nodes, [](const Node& node) { return node.radius > 0; })) return;
    const std::vector<std::int32_t> nearest = nearest_with_radius(document);
    std::vector<double> guessed;
    for (std::int32_t i = 0; i < std::ssize(document.nodes); ++i) {
        Node& node = document.nodes[i];
        if (nearest[i] == i) continue;
        if (nearest[i] >= 0) {
            node.radius = document.nodes[nearest[i]].radius;
            remarks.note("node", "without a positive radius: took the nearest one along the bones", node.id,
                         line_at(lines, i));
        } else {
            if (guessed.empty()) guessed = guess_radii(document);
            node.radius = guessed[i];
            remarks.note("node", "without a positive radius in reach: guessed from the lengths of the bones",
                         node.id, line_at(lines, i));
        }
    }
}

void note_zero_lengths(const Document& document, std::span<const std::int64_t> lines, Remarks& remarks) {
    for (const Bone& bone : bones_of(document))
        if (document.nodes[bone[0]].position == document.nodes[bone[1]].position)
            remarks.note("bone", "of no length: both ends are one place", document.nodes[bone[1]].id,
                         line_at(lines, bone[1]));
}

std::vector<double> guess_radii(const Document& document) {
    const std::size_t count = document.nodes.size();
    std::vector<double> sum(count, 0), bones(count, 0), good;
    for (const Bone& bone : bones_of(document)) {
        const double length = length_of(document, bone);
        if (!(length > 0)) continue;
        for (std::int32_t end : bone) {
            sum[end] += length;
            ++bones[end];
        }
    }
    for (std::size_t i = 0; i < count; ++i)
        if (bones[i] > 0) good.push_back(sum[i] = sum[i] / bones[i] / 5);
    double median = 1;
    if (!good.empty()) {
        std::ranges::nth_element(good, good.begin() + std::ssize(good) / 2);
        median = good[good.size() / 2];
    }
    for (std::size_t i = 0; i < count; ++i)
        if (bones[i] == 0) sum[i] = median;
    return sum;
}

}  // namespace sinew
