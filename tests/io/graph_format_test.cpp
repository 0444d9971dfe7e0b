#include "sinew/io/graph_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "sinew/skeleton/graph.h"
#include "sinew/skeleton/validate.h"

namespace sinew {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(GraphFormat, ReadsNodesBonesAndComments) {
    const ReadSkeleton read =
        parse_graph("# a graph\r\nc 0 1  # before its nodes\r\n\r\n  n 1 +2 -3e-1 .5 extra\r\n\tn\t0 0 0 1")
            .value();
    EXPECT_TRUE(read.measured);
    EXPECT_THAT(read.warnings, IsEmpty());
    ASSERT_EQ(read.document.nodes.size(), 2u);
    EXPECT_EQ(read.document.nodes[0].position, Vec3(1, 2, -0.3));
    EXPECT_EQ(read.document.nodes[0].radius, 0.5);
    EXPECT_EQ(read.document.nodes[1].parent, 0);
    EXPECT_EQ(read.document.nodes[1].id, 1);
}

TEST(GraphFormat, ACycleIsATreeAndALink) {
    const Document document =
        parse_graph("n 0 0 0 1\nn 5 0 0 1\nn 0 5 0 1\nc 1 2\nc 2 0\nc 0 1").value().document;
    EXPECT_EQ(document.nodes[0].parent, -1);
    EXPECT_EQ(document.nodes[1].parent, 0);
    EXPECT_EQ(document.nodes[2].parent, 0);
    EXPECT_THAT(document.links, ElementsAre(Bone{1, 2}));
}

std::vector<std::string> messages(const Result<ReadSkeleton>& read) {
    std::vector<std::string> texts;
    for (const Warning& warning : read.value().warnings) texts.push_back(warning.message);
    return texts;
}

const char* repairable =
    "n 0 0 0 0\nn 4 0 0 2\nn 5 0 0 -1\nn 5 0 0 3\nc 0 1\nc 1 2\nc 2 3\nc 1 0\nc 3 3\nc 0 1\n";

TEST(GraphFormat, RepairsAreCountedByKind) {
    EXPECT_THAT(
        messages(parse_graph(repairable)),
        ElementsAre(
            "1 bone from a node to itself: dropped (on line 9)",
            "2 bones given more than once: dropped (the first on line 8)",
            "2 nodes without a positive radius: took the nearest one along the bones (the first on line 1)",
            "1 bone of no length: both ends are one place (on line 4)"));
}

TEST(GraphFormat, TheNearestRadiusIsNearestByLength) {
    const Document document = parse_graph(repairable).value().document;
    EXPECT_EQ(document.nodes[0].radius, 2);
    EXPECT_EQ(document.nodes[2].radius, 3);  // at distance 0, not the 2 at distance 1
    EXPECT_TRUE(validate(document));
}

TEST(GraphFormat, WithoutAnyRadiusAFifthOfTheBones) {
    const Document document =
        parse_graph("n 0 0 0 0\nn 10 0 0 0\nn 10 20 0 0\nn 99 0 0 0\nc 0 1\nc 1 2").value().document;
    EXPECT_DOUBLE_EQ(document.nodes[0].radius, 2);
    EXPECT_DOUBLE_EQ(document.nodes[1].radius, 3);
    EXPECT_DOUBLE_EQ(document.nodes[2].radius, 4);
    EXPECT_DOUBLE_EQ(document.nodes[3].radius, 3);  // no bones: the median
}

TEST(GraphFormat, StrictReadingTurnsTheFirstWarningIntoAnError) {
    EXPECT_EQ(
        parse_graph(repairable, {.strict = true}).error().text(),
        ":9: node 3: 1 bone from a node to itself: dropped; correct the file, or read it without --strict");
    EXPECT_TRUE(parse_graph("n 0 0 0 1", {.strict = true}));
}

TEST(GraphFormat, EveryTruncatedFileIsReadOrRefusedWithItsLine) {
    const std::string text = "# g\nn 0.5 1e2 -3 1\nn 0 0 5 1\nn 5 0 5 1\nc 0 1\nc 1 2\nc 2 0\n";
    for (std::size_t length = 0; length < text.size(); ++length) {
        const Result<ReadSkeleton> read = parse_graph(text.substr(0, length));
        if (read) {
            EXPECT_TRUE(validate(read->document)) << length;
        } else if (length > 4) {
            EXPECT_EQ(read.error().line, 1 + std::count(text.data(), text.data() + length, '\n')) << length;
        }
    }
}

double any_coordinate() {
    return std::ldexp(*rc::gen::inRange(-100000, 100000) / 99991.0, *rc::gen::inRange(-60, 60));
}

RC_GTEST_PROP(GraphFormatProperty, AnyGraphReadsBackToTheLastBit, ()) {
    Document document;
    const int count = *rc::gen::inRange(1, 20);
    for (int i = 0; i < count; ++i)
        document.nodes.push_back({.id = i,
                                  .parent = *rc::gen::inRange(-1, i),
                                  .position = {any_coordinate(), any_coordinate(), any_coordinate()},
                                  .radius = std::abs(any_coordinate()) + 1e-9});
    const Document back = parse_graph(print_graph(document).value().text).value().document;
    for (int i = 0; i < count; ++i) {
        RC_ASSERT(back.nodes[i].position == document.nodes[i].position);
        RC_ASSERT(back.nodes[i].radius == document.nodes[i].radius);
    }
    auto undirected = [](const Document& d) {
        std::vector<Bone> bones = bones_of(d);
        for (Bone& bone : bones) std::ranges::sort(bone);
        std::ranges::sort(bones);
        return bones;
    };
    RC_ASSERT(undirected(back) == undirected(document));
}

}  // namespace
}  // namespace sinew
