#include "sinew/sqm/name_drawn.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "sinew/skeleton/graph.h"

namespace sinew::sqm {
namespace {

using NodePair = std::array<std::int32_t, 2>;  ///< the lower index first

NodePair pair_of(std::int32_t a, std::int32_t b) { return {std::min(a, b), std::max(a, b)}; }

/// Bone of the expanded document -> the drawn one between the nodes that its own are images of; -1: none.
std::vector<std::int32_t> drawn_bones(const Document& drawn, const ExpandedSymmetry& expanded) {
    std::vector<std::pair<NodePair, std::int32_t>> known;
    for (const Bone& bone : bones_of(drawn))
        known.emplace_back(pair_of(bone[0], bone[1]), std::int32_t(known.size()));
    std::sort(known.begin(), known.end());
    std::vector<std::int32_t> bones;
    for (const Bone& bone : bones_of(expanded.document)) {
        const NodePair wanted = pair_of(expanded.source[bone[0]], expanded.source[bone[1]]);
        const auto at = std::lower_bound(known.begin(), known.end(), std::pair(wanted, std::int32_t{0}));
        bones.push_back(at != known.end() && at->first == wanted ? at->second : -1);
    }
    return bones;
}

}  // namespace

void name_drawn(const Document& drawn, const ExpandedSymmetry& expanded, QuadMesh& mesh) {
    const std::vector<std::int32_t> bones = drawn_bones(drawn, expanded);
    for (std::int32_t& node : mesh.vertex_node)
        if (node >= 0) node = expanded.source[node];
    for (std::int32_t& bone : mesh.vertex_bone)
        if (bone >= 0) bone = bones[bone];
}

}  // namespace sinew::sqm
