#include "sinew/skeleton/graph.h"

#include <numeric>

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

}  // namespace sinew
