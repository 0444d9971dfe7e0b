#include "sinew/io/ply.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "io/mesh_testing.h"

namespace sinew {
namespace {

using testing::HasSubstr;

constexpr PlyEncoding encodings[] = {PlyEncoding::ascii, PlyEncoding::little_endian, PlyEncoding::big_endian};

RC_GTEST_PROP(Ply, WhatIsWrittenIsReadBackBitForBit, ()) {
    const QuadMesh mesh = *any_mesh(300);  // more than 255 corners need a wider count
    for (const PlyEncoding encoding : encodings) {
        const Result<QuadMesh> read = parse_ply(ply_bytes(mesh, encoding), "m.ply");
        RC_ASSERT(read.has_value());
        expect_same_mesh(*read, mesh);
    }
    RC_ASSERT(!testing::Test::HasFailure());
}

TEST(Ply, OnlyTheWholeOfABinaryFileIsRead) {
    for (const PlyEncoding encoding : {PlyEncoding::little_endian, PlyEncoding::big_endian}) {
        const std::string bytes = ply_bytes(shapes::tube(3, 5), encoding);
        EXPECT_EQ(read_prefixes(bytes, [](std::string_view prefix) { return parse_ply(prefix, "cut"); }), 0u);
    }
}

TEST(Ply, PrefixesOfTextFailUntilTheLastNumber) {
    // Without its end "12" is still a number: only the last word of the file can be cut unseen.
    const std::string text = ply_bytes(shapes::cube(), PlyEncoding::ascii);
    EXPECT_LE(read_prefixes(text, [](std::string_view prefix) { return parse_ply(prefix, "cut"); }), 2u);
}

TEST(Ply, ReadsWhatOthersWrite) {
    // Comments, other elements before, between and after, other properties, doubles, shorts, the other list
    // name.
    const std::string text =
        "ply\r\nformat ascii 1.0\r\ncomment made by hand\r\nobj_info nothing\r\n"
        "element material 1\r\nproperty list uchar int numbers\r\nproperty float shine\r\n"
        "element vertex 3\r\nproperty uchar red\r\nproperty double x\r\nproperty short y\r\nproperty float32 "
        "z\r\n"
        "property list uint8 float weights\r\n"
        "element nothing 9\r\n"
        "element face 1\r\nproperty uchar flags\r\nproperty list uint16 uint vertex_index\r\n"
        "property list uchar float texcoord\r\n"
        "element edge 1\r\nproperty int vertex1\r\nproperty int vertex2\r\nend_header\r\n"
        "2 7 8 0.5\r\n"
        "255 0 0 +0.25 0\r\n0 1e0 0 .5 1 0.5\r\n0 0\t2 0 2 1 1\r\n"
        "3 3 0 1 2 6 0 0 1 0 1 1\r\n"
        "0 1";  // the edge is cut off, and nobody needs it to see that
    const Result<QuadMesh> cut = parse_ply(text, "a.ply");
    EXPECT_EQ(error_text(cut), "") << "two numbers are all that an edge has";
    expect_same_mesh(*cut, shapes::from_faces({{0, 0, 0.25f}, {1, 0, 0.5f}, {0, 2, 0}}, {{0, 1, 2}}));
}

TEST(Ply, MalformedFilesAreRefusedWithTheirPlace) {
    const std::string format = "ply\nformat ascii 1.0\n";
    const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
    const std::string header = format + "element vertex 3\n" + xyz +
                               "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
    const std::pair<std::string, std::string> cases[] = {
        {"", "bad.ply:1: this is no PLY file"},
        {"plywood\n", "bad.ply:1: this is no PLY file"},
        {"ply\n", "bad.ply:1: the header does not end"},
        {"ply\nend_header\n", "bad.ply:2: the header names no format"},
        {"ply\nformat ascii 2.0\n", "bad.ply:2: an unknown format"},
        {"ply\nformat binary_middle_endian 1.0\n", "bad.ply:2: an unknown format"},
        {format + "elephant\n", "bad.ply:3: 'elephant' is no keyword"},
        {format + "element vertex -1\n", "bad.ply:3: an element without a name and a count"},
        {format + "element vertex 1e3\n", "bad.ply:3: an element without a name and a count"},
        {format + "element a 1\nelement a 2\n", "bad.ply:4: a second element 'a'"},
        {format + "property float x\n", "bad.ply:3: a property before the first element"},
        {format + "element vertex 3\nproperty half x\n", "bad.ply:4: an unknown type"},
        {format + "element vertex 3\nproperty list float int x\n", "bad.ply:4: an unknown type"},
        {format + "element vertex 3\nproperty float\n", "bad.ply:4: a property without a type and a name"},
        {format + "element vertex 3\nproperty float x\nend_header\n", "bad.ply: the element vertex needs"},
        {format + "element vertex 0\n" + xyz + "element face 1\nproperty int vertex_indices\nend_header\n",
         "bad.ply: the element face needs"},
        {format + "element vertex 0\n" + xyz + "end_header\n", "bad.ply: there is no face in it"},
        {header + "0 0 0\n1 zero 0\n", "bad.ply:11: vertex 1 of 3: y is no number"},
        {header + "0 0 0\n1 inf 0\n", "bad.ply:11: vertex 1 of 3: a coordinate is not finite"},
        {header + "0 0 0\n1 0", "bad.ply:11: vertex 1 of 3: the file ends here"},
        {header + vertices + "2 0 1\n", "bad.ply:13: face 0 of 1: a face of 2 corners"},
        {header + vertices + "-3 0 1 2\n", "bad.ply:13: face 0 of 1: vertex_indices has no count"},
        {header + vertices + "3 0 1 -2\n", "bad.ply:13: face 0 of 1: -2 is no vertex"},
        {header + vertices + "3 0 1 3\n", "bad.ply: face 0 names vertex 3, but the file has 3"},
        {header + vertices + "3 0 1", "bad.ply:13: face 0 of 1: the file ends here"},
    };
    for (const auto& [text, message] : cases)
        EXPECT_THAT(error_text(parse_ply(text, "bad.ply")), HasSubstr(message)) << text;
}

TEST(Ply, HugeCountsWithoutBytesCostNothing) {
    const std::string text =
        "ply\nformat binary_little_endian 1.0\nelement nothing 9223372036854775807\n"
        "element vertex 9223372036854775807\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uint int vertex_indices\nend_header\n";
    EXPECT_THAT(error_text(parse_ply(text, "bad.ply")), HasSubstr("the file ends here"));
}

}  // namespace
}  // namespace sinew
