#include "sinew/skeleton/condition.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sinew/base/round_cone.h"

namespace sinew {
namespace {

Document chain(std::initializer_list<std::pair<Vec3, double>> balls) {
    Document d;
    for (const auto& [position, radius] : balls) {
        Node node;
        node.id = 10 + std::ssize(d.nodes);
        node.parent = static_cast<std::int32_t>(d.nodes.size()) - 1;
        node.position = position;
        node.radius = radius;
        d.nodes.push_back(node);
    }
    return d;
}
GraphCounts counts_of(const CleanGraph& graph) {
    return count_graph(static_cast<std::int32_t>(graph.position.size()), graph.bones);
}

TEST(Condition, LeavesASoundSkeletonAsItIs) {
    Document d = chain({{{0, 0, 0}, 1}, {{5, 0, 0}, 1}, {{9, 3, 0}, 0.5}});
    d.links = {{0, 2}};
    const CleanGraph graph = condition(d);
    EXPECT_EQ(graph.source_node, (std::vector<std::int32_t>{0, 1, 2}));
    EXPECT_EQ(graph.source_bone, (std::vector<std::int32_t>{0, 1, 2}));
    EXPECT_TRUE(graph.warnings.empty());
    EXPECT_EQ(counts_of(graph).cycles, 1);
}

TEST(Condition, MergesBonesOfNoLengthAndDropsDuplicates) {
    Document d = chain({{{0, 0, 0}, 1}, {{5, 0, 0}, 1}, {{5, 0, 0}, 1}, {{9, 0, 0}, 1}});
    d.links = {{1, 0}, {0, 2}};
    const CleanGraph graph = condition(d);
    EXPECT_EQ(graph.position.size(), 3u);
    EXPECT_EQ(graph.bones.size(), 2u);
    EXPECT_EQ(counts_of(graph).cycles, 0);
    EXPECT_FALSE(graph.warnings.empty());
}

TEST(Condition, ThinsRunsOnlyWhereItMayRepair) {
    Document d = chain({{{0, 0, 0}, 1}});
    for (int i = 1; i <= 100; ++i) {
        Node node = d.nodes[0];
        node.id = 10 + i;
        node.parent = i - 1;
        node.position = {0.1 * i, 0, 0};
        d.nodes.push_back(node);
    }
    EXPECT_EQ(condition(d).position.size(), 101u);
    const ConditionOptions repair{.repair = true};
    const CleanGraph graph = condition(d, repair);
    EXPECT_LT(graph.position.size(), 25u);
    EXPECT_GT(graph.position.size(), 5u);
    const auto keeps = [&](std::int32_t node) {
        return std::find(graph.source_node.begin(), graph.source_node.end(), node) != graph.source_node.end();
    };
    EXPECT_TRUE(keeps(0) && keeps(100));
    for (const auto& [a, b] : graph.bones)
        EXPECT_GE((graph.position[a] - graph.position[b]).norm(), repair.spacing - 1e-9);
    for (std::size_t i = 0; i < graph.position.size(); ++i) {
        EXPECT_EQ(graph.position[i], d.nodes[graph.source_node[i]].position);
        EXPECT_EQ(graph.radius[i], 1);
    }
}

TEST(Condition, MergesANestedBallIntoItsNeighbour) {
    const Document d = chain({{{0, 0, 0}, 3}, {{0.5, 0, 0}, 2.5}, {{8, 0, 0}, 2.5}});
    EXPECT_EQ(condition(d).position.size(), 3u);
    const CleanGraph graph = condition(d, {.repair = true});
    EXPECT_EQ(graph.source_node, (std::vector<std::int32_t>{0, 2}));
    ASSERT_EQ(graph.bones.size(), 1u);
    ASSERT_EQ(graph.warnings.size(), 1u);
    EXPECT_EQ(graph.warnings[0].count, 1);
    EXPECT_EQ(graph.warnings[0].nodes, std::vector<std::int64_t>{11});
}

/// How wide the tubes of a graph are at a place: the radius of the widest round cone there.
double width_at(const CleanGraph& graph, const Vec3& place) {
    double widest = 0;
    for (const auto& [a, b] : graph.bones) {
        const ConeFrom cone(graph.position[a], graph.radius[a], graph.position[b], graph.radius[b]);
        const double height = (place - graph.position[a]).dot(cone.axis);
        if (height > -graph.radius[a] && height < cone.length + graph.radius[b])
            widest = std::max(widest, cone.radius_at(height));
    }
    return widest;
}

TEST(Condition, KeepsTheWidthOfAThinTubeThatBeginsInsideABall) {
    const Document d = chain({{{0, 0, 0}, 3}, {{0.5, 0, 0}, 0.4}, {{20, 0, 0}, 0.2}});
    const CleanGraph graph = condition(d, {.repair = true});
    EXPECT_EQ(graph.source_node, (std::vector<std::int32_t>{0, 2, 1}));
    EXPECT_EQ(graph.radius[0], 3);
    EXPECT_EQ(counts_of(graph).components, 1);
    for (const double x : {4.0, 8.0, 16.0})
        EXPECT_NEAR(width_at(graph, {x, 0, 0}), 0.4 - 0.2 * (x - 0.5) / 19.5, 0.02);
}

TEST(Condition, KeepsTheWidthsOfTubesBetweenBallsThatAreLargerThanThem) {
    const Document d = chain({{{0, 0, 0}, 3}, {{1, 0, 0}, 0.5}, {{19, 0, 0}, 0.5}, {{20, 0, 0}, 3}});
    const CleanGraph graph = condition(d, {.repair = true});
    for (const double x : {4.0, 10.0, 16.0}) EXPECT_NEAR(width_at(graph, {x, 0, 0}), 0.5, 1e-9);
    for (const double x : {0.0, 20.0}) EXPECT_NEAR(width_at(graph, {x, 0, 0}), 3, 1e-9);
}

/// Thinning begins beside the ball, and must not eat its way along the tube.
TEST(Condition, KeepsTheWidthOfADenseRunThatLeavesABall) {
    Document d = chain({{{0, 0, 0}, 2}});
    for (int i = 1; i <= 400; ++i) {
        Node node;
        node.id = 100 + i;
        node.parent = i - 1;
        node.position = {0.05 * i, 0, 0};
        node.radius = 0.3;
        d.nodes.push_back(node);
    }
    const CleanGraph graph = condition(d, {.repair = true});
    EXPECT_LT(graph.position.size(), 150u);
    for (double x = 2.5; x < 20; x += 0.5) EXPECT_NEAR(width_at(graph, {x, 0, 0}), 0.3, 0.03) << x;
}

TEST(Condition, LeavesANodeOnAllRunsButOneBetweenTheSameTwo) {
    Document d = chain({{{0, 0, 0}, 0.3}, {{0, 0, -1}, 1}});
    for (int i = 0; i < 5; ++i) {
        Node node;
        node.id = 20 + i;
        node.parent = 1;
        node.position = {0.7 * std::cos(i), 0.7 * std::sin(i), -0.6};
        node.radius = 0.25;
        d.nodes.push_back(node);
        d.links.push_back({i + 2, 0});
    }
    const CleanGraph graph = condition(d, {.repair = true});
    EXPECT_EQ(counts_of(graph).cycles, 5);
    std::vector<Bone> bones = graph.bones;
    for (Bone& bone : bones) std::sort(bone.begin(), bone.end());
    std::sort(bones.begin(), bones.end());
    EXPECT_EQ(std::adjacent_find(bones.begin(), bones.end()), bones.end());
}

TEST(Condition, KeepsComponentsAndCyclesWhenItRepairs) {
    Document d;  // a ring of many nodes, all nearly within one ball, and a ball alone
    for (int i = 0; i < 40; ++i) {
        Node node;
        node.id = i;
        node.parent = i - 1;
        node.position = {std::cos(2 * M_PI * i / 40), std::sin(2 * M_PI * i / 40), 0};
        node.radius = i % 7 == 0 ? 0.9 : 0.3;
        d.nodes.push_back(node);
    }
    d.links = {{0, 39}};
    Node alone;
    alone.id = 99;
    alone.position = {9, 0, 0};
    d.nodes.push_back(alone);
    const GraphCounts counts = counts_of(condition(d, {.repair = true}));
    EXPECT_EQ(counts.components, 2);
    EXPECT_EQ(counts.cycles, 1);
}

}  // namespace
}  // namespace sinew
