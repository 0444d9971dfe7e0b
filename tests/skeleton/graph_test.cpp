#include "sinew/skeleton/graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sinew {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// 0 - 1 - 2 - 0 is a triangle, 3 - 4 a bone, 5 alone; 1 - 2 is there twice.
const std::vector<Bone> bones{{0, 1}, {1, 2}, {2, 0}, {4, 3}, {1, 2}};

TEST(Graph, BonesAreThoseToTheParentsThenTheLinks) {
    Document document;
    document.nodes.resize(3);
    document.nodes[0].parent = 2;
    document.nodes[1].parent = 0;
    document.links = {{2, 1}};
    EXPECT_THAT(bones_of(document), ElementsAre(Bone{2, 0}, Bone{0, 1}, Bone{2, 1}));
}

TEST(Graph, AdjacencyListsTheBonesOfEachNode) {
    const Adjacency around = adjacency(6, bones);
    EXPECT_THAT(around.bones(1), ElementsAre(0, 1, 4));
    EXPECT_THAT(around.bones(5), IsEmpty());
    EXPECT_EQ(around.degree(2), 3);
}

TEST(Graph, LeavesHaveOneBoneOfAnyKind) {
    Document document;  // 0 - 1 - 2, 1 - 3, and a link 3 - 4; 5 alone
    document.nodes.resize(6);
    for (const auto& [child, parent] : {std::pair{1, 0}, {2, 1}, {3, 1}})
        document.nodes[child].parent = parent;
    document.links = {{3, 4}};
    EXPECT_THAT(leaves_of(document), ElementsAre(0, 2, 4));
    EXPECT_EQ(adjacency(document).degree(3), 2);
}

TEST(Graph, CyclesAreBonesMinusNodesPlusComponents) {
    const GraphCounts counts = count_graph(6, bones);
    EXPECT_EQ(counts.components, 3);
    EXPECT_EQ(counts.cycles, 5 - 6 + 3);
}

TEST(Graph, ASpanningForestHasATreeAComponentAndABoneACycle) {
    const SpanningForest forest = spanning_forest(6, bones);
    EXPECT_THAT(forest.parent, ElementsAre(-1, 0, 0, -1, 3, -1));
    EXPECT_THAT(forest.rest, ElementsAre(1, 4));
}

TEST(Graph, ASpanningForestStartsAtTheRootsAskedFor) {
    const std::vector<std::int32_t> roots{4, 2};
    EXPECT_THAT(spanning_forest(6, bones, roots).parent, ElementsAre(2, 2, -1, 4, -1, -1));
}

}  // namespace
}  // namespace sinew
