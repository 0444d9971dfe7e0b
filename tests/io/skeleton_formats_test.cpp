// Skeletons through the front door: malformed files with the message that each must give, and round trips
// between formats.
#include "sinew/io/skeleton_formats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "io/temporary_folder.h"
#include "sinew/io/files.h"
#include "sinew/skeleton/graph.h"

namespace sinew {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

const std::string malformed = SINEW_SOURCE_FOLDER "/tests/io/malformed/";

std::vector<std::pair<std::string, std::string>> expected_messages() {
    std::vector<std::pair<std::string, std::string>> rows;
    std::istringstream lines(read_file(malformed + "EXPECT.tsv").value());
    for (std::string line; std::getline(lines, line);)
        rows.emplace_back(line.substr(0, line.find('\t')), line.substr(line.find('\t') + 1));
    return rows;
}

TEST(SkeletonFormats, MalformedFilesGiveTheMessageBesideThem) {
    std::set<std::string> left;
    for (const auto& entry : std::filesystem::directory_iterator(malformed))
        left.insert(entry.path().filename());
    left.erase("EXPECT.tsv");
    for (const auto& [name, message] : expected_messages()) {
        Result<ReadSkeleton> read = parse_skeleton(read_file(malformed + name).value(), name);
        EXPECT_EQ(read ? "no error" : read.error().text(), name + message);
        left.erase(name);
    }
    EXPECT_THAT(left, IsEmpty());
}

TEST(SkeletonFormats, ErrorsNameTheFile) {
    EXPECT_THAT(read_skeleton(malformed + "nan.graph").error().text(),
                HasSubstr("malformed/nan.graph:3:5: the y is"));
    EXPECT_THAT(read_skeleton(malformed + "none.graph").error().text(),
                HasSubstr("none.graph: cannot be opened"));
    EXPECT_EQ(read_skeleton(malformed + "none.obj").error().kind, ErrorKind::call);
}

/// Two trees and a cycle, with everything that only the native format carries.
const char* const rich = R"({"format": "sinew", "version": 1, "unit": "m", "nodes": [
    {"id": 3, "position": [0, 0, 0.1], "radius": 0.5, "name": "a"},
    {"id": 1, "parent": 3, "position": [1, 0, 0], "radius": 0.25, "type": "cube"},
    {"id": 7, "parent": 3, "position": [0, 1e-9, 3], "radius": 0.125, "joint": "sharp"},
    {"id": 9, "position": [5, 5, 5], "radius": 1}],
    "links": [[1, 7]]})";

TEST(SkeletonFormats, AFileIsWrittenAndReadBack) {
    TemporaryFolder folder;
    const Document document = parse_skeleton(rich, "a.sinew").value().document;
    EXPECT_THAT(write_skeleton(document, folder / "b.sinew").value(), IsEmpty());
    EXPECT_EQ(print_skeleton(read_skeleton(folder / "b.sinew").value().document, "c.sinew").value().text,
              print_skeleton(document, "c.sinew").value().text);
}

TEST(SkeletonFormats, AGraphKeepsPositionsRadiiAndBones) {
    const Document document = parse_skeleton(rich, "a.sinew").value().document;
    const WrittenSkeleton graph = print_skeleton(document, "a.graph").value();
    const Document back = parse_skeleton(graph.text, "a.graph").value().document;
    ASSERT_EQ(back.nodes.size(), document.nodes.size());
    for (std::size_t i = 0; i < back.nodes.size(); ++i) {
        EXPECT_EQ(back.nodes[i].position, document.nodes[i].position);
        EXPECT_EQ(back.nodes[i].radius, document.nodes[i].radius);
    }
    EXPECT_EQ(bones_of(back), bones_of(document));
    ASSERT_EQ(graph.warnings.size(), 2u);
    EXPECT_THAT(graph.warnings[0].message, HasSubstr("2 nodes lost the type or shape"));
    EXPECT_THAT(graph.warnings[1].message, HasSubstr("1 node lost the name"));
}

TEST(SkeletonFormats, FormatsWithoutSymmetryGetAllImages) {
    Document document = parse_skeleton(rich, "a.sinew").value().document;
    document.symmetry = {Symmetry::Kind::mirror, 0, 1};
    const Document back =
        parse_skeleton(print_skeleton(document, "a.graph").value().text, "a.graph").value().document;
    EXPECT_EQ(back.nodes.size(), 6u);  // two are on the plane
    EXPECT_EQ(back.nodes[5].position, Vec3(-5, 5, 5));
}

TEST(SkeletonFormats, AnSwcFileKeepsTheTree) {
    const Document document = parse_skeleton(rich, "a.sinew").value().document;
    const WrittenSkeleton swc = print_skeleton(document, "a.swc").value();
    EXPECT_EQ(swc.text,
              "# id type x y z radius parent\n"
              "1 0 0 0 0.1 0.5 -1\n2 0 1 0 0 0.25 1\n3 0 0 1e-09 3 0.125 1\n4 0 5 5 5 1 -1\n");
    EXPECT_THAT(swc.warnings.back().message, HasSubstr("numbered anew"));
    EXPECT_THAT(swc.warnings[2].message, HasSubstr("1 link was lost"));
}

}  // namespace
}  // namespace sinew
