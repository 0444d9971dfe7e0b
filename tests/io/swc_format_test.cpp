#include "sinew/io/swc_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sinew/skeleton/validate.h"

namespace sinew {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TEST(SwcFormat, ReadsAnyOrderCommentsIndentationAndFurtherColumns) {
    const ReadSkeleton read =
        parse_swc("# neuron\r\n 30 3 0 0 8 .5 7 # leaf\r\n\r\n7\t3 0 0 +5 0.5 10 9 9\r\n\t10 1 0 0 0 3. -1")
            .value();
    EXPECT_TRUE(read.measured);
    EXPECT_THAT(read.warnings, IsEmpty());
    const Document& d = read.document;
    EXPECT_EQ(d.unit, "um");
    ASSERT_THAT(d.nodes, SizeIs(3));
    EXPECT_EQ(d.nodes[0].id, 30);
    EXPECT_EQ(d.nodes[0].parent, 1);
    EXPECT_EQ(d.nodes[1].parent, 2);
    EXPECT_EQ(d.nodes[1].position, Vec3(0, 0, 5));
    EXPECT_EQ(d.nodes[2].parent, -1);
    EXPECT_EQ(d.extras[0], R"({"swc_type":3})");
}

TEST(SwcFormat, AThreePointSomaIsOneNode) {
    const ReadSkeleton read =
        parse_swc("1 1 1 2 3 5 -1\n2 1 1 -3 3 5 1\n3 1 1 7.01 3 5 1\n4 3 1 2 20 1 1\n5 3 1 20 3 1 3\n")
            .value();
    EXPECT_THAT(read.warnings, IsEmpty());
    ASSERT_THAT(read.document.nodes, SizeIs(3));
    EXPECT_EQ(read.document.nodes[0].position, Vec3(1, 2, 3));
    EXPECT_EQ(read.document.nodes[0].radius, 5);
    EXPECT_EQ(read.document.nodes[2].parent, 0);  // it hung at a folded point
}

TEST(SwcFormat, SomataOfOtherKindsAreBones) {
    EXPECT_THAT(parse_swc("1 1 0 0 0 5 -1\n2 1 0 -5 0 5 1\n3 1 5 0 0 5 1\n").value().document.nodes,
                SizeIs(3));
    EXPECT_THAT(
        parse_swc("1 1 0 0 0 9 -1\n2 1 0 0 1 8 1\n3 1 0 0 2 7 2\n4 1 0 0 3 5 3\n").value().document.nodes,
        SizeIs(4));
    EXPECT_THAT(
        parse_swc("1 1 0 0 0 1 -1\n2 1 0 9 0 1 1\n3 1 0 19 0 1 2\n4 1 0 29 0 1 3\n").value().document.nodes,
        SizeIs(4));
}

TEST(SwcFormat, AContourIsASphere) {
    std::string text;
    for (int k = 0; k < 12; ++k) {
        const double angle = k * std::numbers::pi / 6;
        text += std::to_string(k + 1) + " 1 " + std::to_string(100 + 8 * std::cos(angle)) + " " +
                std::to_string(8 * std::sin(angle)) + " 4 0.1 " + (k == 0 ? "-1" : std::to_string(k)) + "\n";
    }
    const ReadSkeleton read = parse_swc(text + "13 3 100 0 30 1 6\n").value();
    ASSERT_THAT(read.document.nodes, SizeIs(2));
    EXPECT_NEAR((read.document.nodes[0].position - Vec3(100, 0, 4)).norm(), 0, 1e-5);
    EXPECT_NEAR(read.document.nodes[0].radius, 8, 1e-5);
    EXPECT_EQ(read.document.nodes[1].parent, 0);
    ASSERT_THAT(read.warnings, SizeIs(1));
    EXPECT_EQ(read.warnings[0].message, "1 soma drawn as a contour: now a sphere (on line 1)");
}

TEST(SwcFormat, BadRadiiTakeTheNearestGoodOne) {
    const ReadSkeleton read = parse_swc("1 1 0 0 0 5 -1\n2 3 0 0 9 0 1\n3 3 0 0 10 1 2\n").value();
    EXPECT_EQ(read.document.nodes[1].radius, 1);
    EXPECT_EQ(read.warnings[0].nodes, std::vector<std::int64_t>{2});
}

TEST(SwcFormat, TypesAndIdsGoThroughLoadAndSave) {
    const std::string text =
        "# id type x y z radius parent\n4 1 0 0 0 5 -1\n8 -2 0.1 0 9 1 4\n9 7 0 0 10 1 8\n";
    const WrittenSkeleton written = print_swc(parse_swc(text).value().document).value();
    EXPECT_EQ(written.text, text);
    EXPECT_THAT(written.warnings, IsEmpty());
}

TEST(SwcFormat, ParentsAreWrittenFirst) {
    const Document d = parse_swc("3 3 0 0 8 1 2\n2 3 0 0 5 1 1\n1 1 0 0 0 1 -1\n").value().document;
    EXPECT_EQ(print_swc(d).value().text,
              "# id type x y z radius parent\n1 1 0 0 0 1 -1\n2 3 0 0 5 1 1\n3 3 0 0 8 1 2\n");
}

TEST(SwcFormat, EveryTruncatedFileIsReadOrRefusedWithItsLine) {
    const std::string text = "# n\n1 1 0 0 0 1 -1\n2 3 0 0.5 5 1 1\n3 3 1e1 0 5 1 1\n";
    for (std::size_t length = 0; length < text.size(); ++length) {
        const Result<ReadSkeleton> read = parse_swc(text.substr(0, length));
        if (read) {
            EXPECT_TRUE(validate(read->document)) << length;
        } else if (length > 4) {
            EXPECT_EQ(read.error().line, 1 + std::count(text.data(), text.data() + length, '\n')) << length;
        }
    }
}

}  // namespace
}  // namespace sinew
