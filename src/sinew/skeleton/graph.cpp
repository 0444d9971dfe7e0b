#include "sinew/skeleton/graph.h"

#include <numeric>
#include <utility>

namespace sinew {

std::vector<Bone> bones_of(const Document& document) {
    std::vector<Bone> bones;
    bones.reserve(document.nodes.size() + document.links.size());
    for (std::int32_t i = 0; i < std::ssize(document.nodes); ++i)
        if (document.nodes[i].parent >= 0) bones.push_back({document.nodes[i].parent, i});
    bones.insert(bones.end(), document.links.begin(), document.links.end());
    return bones;
}

Adjacency adjacency(std::int32_t node_count, std::span<const Bone> bones) {
    Adjacency result;
    result.first.assign(node_count + 1, 0);
    for (const Bone& bone : bones)
        for (std::int32_t node : bone) ++result.first[node + 1];
    std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
    result.incident.resize(2 * bones.size());
    std::vector<std::int32_t> next(result.first.begin(), result.first.end() - 1);
    for (std::int32_t b = 0; b < std::ssize(bones); ++b)
        for (std::int32_t node : bones[b]) result.incident[next[node]++] = b;
    return result;
}

Adjacency adjacency(const Document& document) {
    return adjacency(static_cast<std::int32_t>(document.nodes.size()), bones_of(document));
}

std::vector<std::int32_t> leaves_of(const Document& document) {
    const Adjacency around = adjacency(document);
    std::vector<std::int32_t> leaves;
    for (std::int32_t i = 0; i < std::ssize(document.nodes); ++i)
        if (around.degree(i) == 1) leaves.push_back(i);
    return leaves;
}

GraphCounts count_graph(std::int32_t node_count, std::span<const Bone> bones) {
    std::vector<std::int32_t> parent(node_count);
    std::iota(parent.begin(), parent.end(), 0);
    auto root = [&](std::int32_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    GraphCounts counts{node_count, 0};
    for (const Bone& bone : bones) {
        std::int32_t a = root(bone[0]), b = root(bone[1]);
        if (a == b) {
            ++counts.cycles;
        } else {
            parent[std::max(a, b)] = std::min(a, b);
            --counts.components;
        }
    }
    return counts;
}

SpanningForest spanning_forest(std::int32_t node_count, std::span<const Bone> bones,
                               std::span<const std::int32_t> roots) {
    const Adjacency around = adjacency(node_count, bones);
    SpanningForest forest;
    forest.parent.assign(node_count, -1);
    std::vector<char> reached(node_count, 0), used(bones.size(), 0);
    std::vector<std::int32_t> queue;
    queue.reserve(node_count);
    auto grow = [&](std::int32_t root) {
        if (std::exchange(reached[root], 1)) return;
        queue.assign(1, root);
        for (std::size_t head = 0; head < queue.size(); ++head)
            for (std::int32_t b : around.bones(queue[head])) {
                const std::int32_t next = bones[b][0] == queue[head] ? bones[b][1] : bones[b][0];
                if (std::exchange(reached[next], 1)) continue;
                forest.parent[next] = queue[head];
                used[b] = 1;
                queue.push_back(next);
            }
    };
    for (std::int32_t root : roots) grow(root);
    for (std::int32_t node = 0; node < node_count; ++node) grow(node);
    for (std::int32_t b = 0; b < std::ssize(bones); ++b)
        if (!used[b]) forest.rest.push_back(b);
    return forest;
}

}  // namespace sinew
