#include "sinew/io/measured.h"

#include <gmock/gmock.h>

namespace sinew {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// A chain along x; ids are ten times the index.
Document chain(const std::vector<std::pair<double, double>>& place_and_radius) {
    Document document;
    for (const auto& [x, radius] : place_and_radius) {
        const auto index = static_cast<std::int32_t>(document.nodes.size());
        document.nodes.push_back(
            {.id = 10 * index, .parent = index - 1, .position = Vec3(x, 0, 0), .radius = radius});
    }
    return document;
}

std::vector<double> radii_of(const Document& document) {
    std::vector<double> radii;
    for (const Node& node : document.nodes) radii.push_back(node.radius);
    return radii;
}

TEST(Remarks, AreCountedByKindWithTheFirstLine) {
    Remarks remarks;
    remarks.note("node", "was odd", 5, 9);
    remarks.note("bone", "was odd", 6, 12);
    remarks.note("node", "was odd", 7, 3);
    const Warnings warnings = remarks.take(false).value();
    ASSERT_THAT(warnings, SizeIs(2));
    EXPECT_EQ(warnings[0].message, "2 nodes was odd (the first on line 3)");
    EXPECT_EQ(warnings[0].count, 2);
    EXPECT_THAT(warnings[0].nodes, ElementsAre(5, 7));
    EXPECT_EQ(warnings[1].message, "1 bone was odd (on line 12)");
}

TEST(Remarks, NameNoMoreThanSixteenNodesAndNoLineWhereThereIsNone) {
    Remarks remarks;
    for (int i = -1; i < 30; ++i) remarks.note("node", "was odd", i);
    const Warnings warnings = remarks.take(false).value();
    ASSERT_THAT(warnings, SizeIs(1));
    EXPECT_EQ(warnings[0].message, "31 nodes was odd");
    ASSERT_THAT(warnings[0].nodes, SizeIs(16));
    EXPECT_EQ(warnings[0].nodes.front(), 0) << "-1 is no node";
}

TEST(Remarks, TheFirstIsAnErrorInAStrictReading) {
    Remarks remarks;
    EXPECT_THAT(remarks.take(true).value(), IsEmpty());
    remarks.note("node", "was odd", 5, 9);
    remarks.note("bone", "was odd", 6, 2);
    const auto strict = remarks.take(true);
    ASSERT_FALSE(strict);
    EXPECT_EQ(strict.error().message, "1 node was odd");
    EXPECT_EQ(strict.error().line, 9);
    EXPECT_EQ(strict.error().node, 5);
}

TEST(RepairRadii, TakesTheNearestAlongTheBones) {
    Document document = chain({{0, 1}, {1, 0}, {2, 0}, {3, -2}, {4.5, 7}});
    Remarks remarks;
    repair_radii(document, {}, remarks);
    EXPECT_THAT(radii_of(document), ElementsAre(1, 1, 1, 7, 7));
    EXPECT_THAT(remarks.take(false).value()[0].nodes, ElementsAre(10, 20, 30));
}

TEST(RepairRadii, GoesAlongTheBonesNotThroughTheAir) {
    Document document = chain({{0, 3}, {10, 0}, {1, 0}});  // there and back: the end is beside the beginning
    document.nodes.push_back({.id = 90, .parent = 2, .position = Vec3(6, 0, 0), .radius = 8});
    Remarks remarks;
    repair_radii(document, {}, remarks);
    EXPECT_THAT(radii_of(document), ElementsAre(3, 3, 8, 8));
}

TEST(RepairRadii, OfTwoAsNearTakesTheLowerNode) {
    for (const bool larger_first : {false, true}) {
        Document document = chain({{0, larger_first ? 5.0 : 2.0}, {1, 0}, {2, larger_first ? 2.0 : 5.0}});
        Remarks remarks;
        repair_radii(document, {}, remarks);
        EXPECT_EQ(document.nodes[1].radius, document.nodes[0].radius);
    }
}

TEST(RepairRadii, AddsUpTheLengthsOnTheWay) {
    Document document = chain({{0, 4}, {6, 0}, {11, 0}, {21, 9}});
    Remarks remarks;
    repair_radii(document, {}, remarks);
    EXPECT_THAT(radii_of(document), ElementsAre(4, 4, 9, 9)) << "11 from the one and 10 from the other";
}

TEST(RepairRadii, GuessesWhereNoneIsInReach) {
    Document document = chain({{0, 0}, {5, 0}});
    document.nodes.push_back({.id = 99, .position = Vec3(0, 0, 9), .radius = 6});
    Remarks remarks;
    const std::vector<std::int64_t> lines{4, 8, 12};
    repair_radii(document, lines, remarks);
    EXPECT_THAT(radii_of(document), ElementsAre(1, 1, 6));
    EXPECT_THAT(remarks.take(false).value()[0].message, testing::HasSubstr("guessed"));
    EXPECT_THAT(remarks.take(false).value()[0].message, testing::HasSubstr("the first on line 4"));
}

TEST(GuessRadii, AreAFifthOfTheMeanLengthOfTheBones) {
    EXPECT_THAT(guess_radii(chain({{0, 0}, {10, 0}, {30, 0}})), ElementsAre(2, 3, 4));
}

TEST(GuessRadii, WithoutALengthAreTheMedianOfTheOthers) {
    EXPECT_THAT(guess_radii(chain({{7, 0}, {7, 0}})), Each(1));
    Document document = chain({{0, 0}, {10, 0}, {30, 0}});
    document.nodes.push_back({.id = 99, .position = Vec3(0, 0, 9)});
    EXPECT_THAT(guess_radii(document), ElementsAre(2, 3, 4, 3));
    document.nodes.push_back(
        {.id = 98, .parent = 0, .position = Vec3(0, 0, 0)});  // of no length: counts for nobody
    EXPECT_THAT(guess_radii(document), ElementsAre(2, 3, 4, 3, 3));
}

TEST(NoteZeroLengths, NamesTheChildAndItsLine) {
    Remarks remarks;
    const std::vector<std::int64_t> lines{2, 5, 6};
    note_zero_lengths(chain({{0, 1}, {0, 1}, {1, 1}}), lines, remarks);
    const Warnings warnings = remarks.take(false).value();
    ASSERT_THAT(warnings, SizeIs(1));
    EXPECT_THAT(warnings[0].nodes, ElementsAre(10));
    EXPECT_THAT(warnings[0].message, testing::HasSubstr("on line 5"));
}

}  // namespace
}  // namespace sinew
