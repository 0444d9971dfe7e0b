#include "sinew/sqm/network.h"

#include <algorithm>

#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

/// What the header says of any network.
void expect_sound(const Plain& skeleton, const Network& n) {
    std::vector<int> walked(skeleton.bones.size(), 0);
    for (std::int32_t p = 0; p < n.path_count(); ++p) {
        const auto nodes = n.nodes(p);
        const auto bones = n.bones(p);
        const std::size_t count = n.path_closed[p] ? nodes.size() : nodes.size() - 1;
        for (std::size_t i = 0; i < count; ++i) {
            ++walked[bones[i]];
            Bone ends = skeleton.bones[bones[i]], expected{nodes[i], nodes[(i + 1) % nodes.size()]};
            std::sort(ends.begin(), ends.end());
            std::sort(expected.begin(), expected.end());
            EXPECT_EQ(ends, expected);
        }
        for (int side = 0; side < 2; ++side) {
            const PathEnd& end = n.path_end[p][side];
            if (!end.at_joint()) continue;
            EXPECT_EQ(n.joint_node[end.joint], side == 0 ? nodes.front() : nodes.back());
            EXPECT_EQ(n.slot_path[n.slot_first[end.joint] + end.slot], (PathAndEnd{p, side}));
        }
    }
    EXPECT_TRUE(std::all_of(walked.begin(), walked.end(), [](int times) { return times == 1; }));
    EXPECT_EQ(std::count(n.slot_path.begin(), n.slot_path.end(), PathAndEnd{}), 0);
}

TEST(Network, OfAStarHasAPathABone) {
    const Plain skeleton = plain_of(star(fan(5)));
    const Network n = find_network(skeleton);
    expect_sound(skeleton, n);
    ASSERT_EQ(n.joint_count(), 1);
    EXPECT_EQ(n.degree(0), 5);
    EXPECT_EQ(n.path_count(), 5);
    for (const auto& ends : n.path_end) EXPECT_NE(ends[0].at_joint(), ends[1].at_joint());
}

TEST(Network, NodesOfTwoBonesLieOnOnePath) {
    const std::vector<Vec3> places{{0, 0, 0}, {2, 0, 0}, {4, 1, 0}, {6, 1, 2}};
    const Plain skeleton = plain_of(chain(places, 0.3));
    const Network n = find_network(skeleton);
    expect_sound(skeleton, n);
    ASSERT_EQ(n.path_count(), 1);
    EXPECT_EQ(n.nodes(0).size(), 4u);
    EXPECT_EQ(n.joint_count(), 0);
}

TEST(Network, ARingWithoutAJointIsOneClosedPath) {
    Document d = chain(fan(6), 0.1);
    d.links = {{0, 5}};
    const Plain skeleton = plain_of(d);
    const Network n = find_network(skeleton);
    expect_sound(skeleton, n);
    ASSERT_EQ(n.path_count(), 1);
    EXPECT_TRUE(n.path_closed[0]);
    EXPECT_EQ(n.nodes(0).size(), 6u);
    EXPECT_FALSE(n.path_end[0][0].at_joint());
}

TEST(Network, ALoopAtAJointComesBackThroughAnotherBone) {
    Document d = chain(fan(6), 0.1);
    d.links = {{0, 5}};
    add(d, 0, {3, 0, 0}, 0.1);
    const Plain skeleton = plain_of(d);
    const Network n = find_network(skeleton);
    expect_sound(skeleton, n);
    ASSERT_EQ(n.path_count(), 2);
    const auto loop = std::find_if(n.path_end.begin(), n.path_end.end(),
                                   [](const auto& e) { return e[0].joint == e[1].joint; });
    ASSERT_NE(loop, n.path_end.end());
    EXPECT_NE((*loop)[0].slot, (*loop)[1].slot);
}

TEST(Network, NodesWithoutBonesAreLone) {
    Document d = star(fan(3));
    add(d, -1, {9, 0, 0}, 1);
    const Network n = find_network(plain_of(d));
    EXPECT_EQ(n.lone, std::vector<std::int32_t>{4});
    EXPECT_EQ(n.joint_count(), 1);
}

TEST(Network, ABodyIsAJointWhateverItsDegree) {
    Document d = star(fan(1));
    d.nodes[0].type = NodeType::ball;
    const Plain skeleton = plain_of(d);
    const Network n = find_network(skeleton);
    expect_sound(skeleton, n);
    EXPECT_EQ(n.joint_node, std::vector<std::int32_t>{0});
}

TEST(Network, OfAnyGraphWalksEveryBoneOnce) {
    property::Random random(1);
    for (int round = 0; round < 50; ++round) {
        Document d = random_tree(random, 3);
        for (int i = 0; i < round % 7; ++i) {
            const int a = random.below(int(d.nodes.size())), b = random.below(int(d.nodes.size()));
            if (a != b) d.links.push_back({a, b});
        }
        const Plain skeleton = plain_of(d);
        expect_sound(skeleton, find_network(skeleton));
    }
}

}  // namespace
}  // namespace sinew::sqm
