#include "sinew/io/gltf_nodes.h"

#include <gmock/gmock.h>

namespace sinew {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

GltfTree tree_of(std::vector<std::vector<std::int32_t>> children) {
    GltfTree tree{.children = std::move(children)};
    tree.to_parent.assign(tree.children.size(), Eigen::Affine3d::Identity());
    return tree;
}

std::string fault_of(std::vector<std::vector<std::int32_t>> children) {
    GltfTree tree = tree_of(std::move(children));
    const Result<void> found = find_parents(tree);
    return found ? "" : found.error().text();
}

TEST(GltfNodes, ScaleComesFirstThenTheTurnThenTheMove) {
    const double half = std::sqrt(0.5);  // a quarter turn about z; twice as long a quaternion turns as much
    for (const double length : {1.0, 2.0}) {
        const auto transform =
            gltf_transform({10, 20, 30}, Quat(length * half, 0, 0, length * half), {2, 3, 4});
        EXPECT_LT((transform * Vec3(1, 1, 1) - Vec3(10 - 3, 20 + 2, 30 + 4)).norm(), 1e-12);
    }
    EXPECT_EQ(gltf_transform({1, 2, 3}, Quat(0, 0, 0, 0), {1, 1, 1}) * Vec3(1, 1, 1), Vec3(2, 3, 4));
}

TEST(GltfNodes, MatricesAreWrittenByColumns) {
    const std::array<double, 16> matrix{0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1};
    EXPECT_EQ(gltf_transform(matrix) * Vec3(1, 0, 0), Vec3(5, 7, 7));
}

TEST(GltfNodes, PlacesAreThoseOfAllAncestors) {
    GltfTree tree = tree_of({{}, {2}, {0}, {}});  // 1 above 2 above 0
    tree.to_parent[0].translate(Vec3(1, 0, 0));
    tree.to_parent[1].scale(2);
    tree.to_parent[2].translate(Vec3(0, 3, 0));
    ASSERT_TRUE(find_parents(tree));
    EXPECT_THAT(tree.parent, ElementsAre(2, -1, 1, -1));
    EXPECT_THAT(roots_of(tree), ElementsAre(1, 3));
    const auto world = to_world(tree);
    EXPECT_EQ(world[0].translation(), Vec3(2, 6, 0));
    EXPECT_EQ(world[2].translation(), Vec3(0, 6, 0));
    EXPECT_EQ(world[3].translation(), Vec3(0, 0, 0));
}

TEST(GltfNodes, ComeOnceAndAfterTheirParents) {
    GltfTree tree = tree_of({{2, 1}, {}, {3}, {}, {}});
    ASSERT_TRUE(find_parents(tree));
    EXPECT_THAT(parents_first(tree, std::vector{0}), ElementsAre(0, 2, 1, 3));
    EXPECT_THAT(parents_first(tree, std::vector{3, 2}), ElementsAre(3, 2)) << "3 is below 2 too";
    EXPECT_THAT(parents_first(tree, std::vector<std::int32_t>{}), IsEmpty());
}

TEST(GltfNodes, WhatIsNoTreeIsRefusedWithItsPlace) {
    EXPECT_EQ(fault_of({{1}, {}}), "");
    EXPECT_THAT(fault_of({{1}, {2}}), HasSubstr("/nodes/1/children/0: there is no such node"));
    EXPECT_THAT(fault_of({{-1}}), HasSubstr("/nodes/0/children/0: there is no such node"));
    EXPECT_THAT(fault_of({{2}, {0, 2}, {}}), HasSubstr("/nodes/1/children/1: the node 2 has two parents"));
    EXPECT_THAT(fault_of({{}, {2}, {1}}), HasSubstr("/nodes/1: the node is its own ancestor"));
    EXPECT_THAT(fault_of({{0}}), HasSubstr("/nodes/0: the node is its own ancestor"));
}

TEST(GltfNodes, UpBecomesUp) {
    EXPECT_EQ(gltf_to_z_up() * Vec3(1, 2, 3), Vec3(1, -3, 2));  // y up, and towards the viewer is -y
}

}  // namespace
}  // namespace sinew
