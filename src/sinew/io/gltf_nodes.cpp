#include "sinew/io/gltf_nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sinew/io/gltf_text.h"

namespace sinew {

Eigen::Affine3d gltf_transform(const Vec3& translation, const Quat& rotation, const Vec3& scale) {
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
    transform.translate(translation);
    if (rotation.squaredNorm() > 0) transform.rotate(rotation.normalized());
    transform.scale(scale);
    return transform;
}

Eigen::Affine3d gltf_transform(std::span<const double, 16> matrix) {
    Eigen::Affine3d transform;
    transform.matrix() = Eigen::Map<const Eigen::Matrix4d>(matrix.data());
    transform.makeAffine();
    return transform;
}

Result<void> find_parents(GltfTree& tree) {
    const auto count = static_cast<std::int32_t>(tree.children.size());
    tree.parent.assign(tree.children.size(), -1);
    for (std::int32_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < tree.children[i].size(); ++k) {
            const std::int32_t child = tree.children[i][k];
            const std::string place = fmt::format("/nodes/{}/children/{}", i, k);
            if (child < 0 || child >= count) return gltf_fault(place, "there is no such node in the file");
            if (std::exchange(tree.parent[child], i) >= 0)
                return gltf_fault(place, fmt::format("the node {} has two parents", child));
        }
    std::vector<std::int32_t> reached = parents_first(tree, roots_of(tree));
    if (reached.size() == tree.children.size()) return {};
    std::ranges::sort(reached);
    std::int32_t lost = 0;
    while (std::ranges::binary_search(reached, lost)) ++lost;
    return gltf_fault(fmt::format("/nodes/{}", lost), "the node is its own ancestor");
}

std::vector<std::int32_t> roots_of(const GltfTree& tree) {
    std::vector<std::int32_t> roots;
    for (std::int32_t i = 0; i < std::ssize(tree.parent); ++i)
        if (tree.parent[i] < 0) roots.push_back(i);
    return roots;
}

std::vector<std::int32_t> parents_first(const GltfTree& tree, std::span<const std::int32_t> from) {
    std::vector<std::int32_t> order;
    std::vector<char> met(tree.children.size(), 0);
    const auto meet = [&](std::span<const std::int32_t> nodes) {
        for (const std::int32_t node : nodes)
            if (!std::exchange(met[node], 1)) order.push_back(node);
    };
    meet(from);
    for (std::size_t i = 0; i < order.size(); ++i) meet(tree.children[order[i]]);
    return order;
}

std::vector<Eigen::Affine3d> to_world(const GltfTree& tree) {
    std::vector<Eigen::Affine3d> world = tree.to_parent;
    for (const std::int32_t node : parents_first(tree, roots_of(tree)))
        if (tree.parent[node] >= 0) world[node] = world[tree.parent[node]] * tree.to_parent[node];
    return world;
}

Eigen::Affine3d gltf_to_z_up() {
    Eigen::Affine3d turn = Eigen::Affine3d::Identity();
    turn.linear() << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    return turn;
}

}  // namespace sinew
