#include "sinew/io/obj.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <clocale>

#include "fixed_seed.h"
#include "io/mesh_testing.h"

namespace sinew {
namespace {

using testing::HasSubstr;

RC_GTEST_PROP(Obj, WhatIsWrittenIsReadBackBitForBit, ()) {
    const QuadMesh mesh = *any_mesh();
    const Result<QuadMesh> read = parse_obj(obj_text(mesh), "m.obj");
    RC_ASSERT(read.has_value());
    expect_same_mesh(*read, mesh);
    RC_ASSERT(!testing::Test::HasFailure());
}

TEST(Obj, TextIsWhatOneWouldWriteByHand) {
    const QuadMesh mesh = shapes::from_faces({{0, 0.1f, -1}, {1e-7f, 2, 1e20f}, {0, 1, 0}}, {{0, 1, 2}});
    EXPECT_EQ(obj_text(mesh),
              "# Sinew: 3 vertices, 1 faces\nv 0 0.1 -1\nv 1e-07 2 1e+20\nv 0 1 0\nf 1 2 3\n");
}

TEST(Obj, ReadsAllWaysToWriteAFace) {
    const QuadMesh expected =
        shapes::from_faces({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    for (const char* face :
         {"f 1 2 3 4\n", "f 1/1 2/2 3/3 4/4", "f 1//1 2//2 3//3 4//4\n", "f 1/9/1 2/9/2 3/-9/-3 4/1/1\n",
          "f -4 -3 -2 -1", "f 1/ 2/ 3/ 4/\n", "\tf  1\t2  3 4  # a comment\n", "f 1 2 \\\n 3 4\n",
          "f 1\\\r\n2 3 4\r\n", "f +1 2 3 4\n"}) {
        const Result<QuadMesh> mesh = parse_obj(vertices + face, "a.obj");
        ASSERT_TRUE(mesh) << face << ": " << mesh.error().text();
        expect_same_mesh(*mesh, expected);
    }
}

TEST(Obj, PassesOverWhatIsNoShape) {
    const char* text =
        "# a comment that goes on \\\n f 1 2\nmtllib a.mtl\no thing\nvn 0 0 1\nvt 0.5 0.5\ng side "
        "top\nusemtl m\ns off\n"
        "f 1 2 3\n"  // vertices may come later
        "v 0 0 0 1.0\nv 1 0 0 0.5 0.5 0.5\nv +1.5 1e-60 .5\nl 1 2\np 1\nvp 0.1\ncurv2 1 2\n\n";
    const Result<QuadMesh> mesh = parse_obj(text, "a.obj");
    ASSERT_TRUE(mesh) << mesh.error().text();
    expect_same_mesh(*mesh, shapes::from_faces({{0, 0, 0}, {1, 0, 0}, {1.5f, 0, 0.5f}}, {{0, 1, 2}}));
}

TEST(Obj, LineEndsOfAllSystems) {
    for (const char* text :
         {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n",
          "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r"})
        EXPECT_EQ(error_text(parse_obj(text, "a.obj")), "");
}

TEST(Obj, ABackslashJoinsLinesWhateverTheirEnd) {
    const QuadMesh whole = *parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj");
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        const std::string text =
            "v 0 \\" + end + "0 0\nv 1 0 0\nv 0 1 0\nf 1 \\" + end + "2\\" + end + " 3\n";
        const auto read = parse_obj(text, "a.obj");
        ASSERT_EQ(error_text(read), "");
        expect_same_mesh(*read, whole);
    }
}

TEST(Obj, MalformedFilesAreRefusedWithTheirPlace) {
    const std::string good = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    const std::pair<std::string, std::string> cases[] = {
        {"", "bad.obj: there is no face in it"},
        {good, "bad.obj: there is no face in it"},
        {"v 0 zero 0\n", "bad.obj:1:5: a vertex needs three numbers"},
        {"v 0 0\nf 1 1 1\n", "bad.obj:1:6: a vertex needs three numbers"},
        {"v 0 0 0,5\n", "bad.obj:1:7: a vertex needs three numbers"},
        {"v 0 nan 0\n", "bad.obj:1:5: a coordinate is not finite"},
        {"v 0 0 1e99\n", "bad.obj:1:7: a coordinate is not finite"},
        {good + "f 1 2\n", "bad.obj:4:6: a face of 2 corners"},
        {good + "f\n", "bad.obj:4:2: a face of 0 corners"},
        {good + "f 0 1 2\n", "bad.obj:4:3: the face names vertex 0"},
        {good + "# one \\\ntwo\nf 1 2 3\nf 1 2 4\n",
         "bad.obj:7: the face names vertex 4, but the file has 3"},
        {good + "f 1 2 -4\n", "bad.obj:4:7: the face names vertex -4, but the file has 3"},
        {good + "f 1 2 99999999999\n", "bad.obj:4:7: the face names vertex 99999999999"},
        {good + "f 1 2 99999999999999999999\n", "bad.obj:4:7: a corner of a face is no vertex number"},
        {good + "f 1 2 3x\n", "bad.obj:4:7: a corner of a face is no vertex number"},
        {good + "f 1 2 3/1/1/1\n", "bad.obj:4:7: a corner of a face is no vertex number"},
        {good + "f 1 2 \\\n 3 x\n", "bad.obj:5:4: a corner of a face is no vertex number"},
    };
    for (const auto& [text, message] : cases) {
        const Result<QuadMesh> mesh = parse_obj(text, "bad.obj");
        EXPECT_THAT(error_text(mesh), HasSubstr(message)) << text;
    }
}

TEST(Obj, NoPrefixOfAFileDoesHarm) {
    const std::string text = obj_text(shapes::tube(3, 5)) + "f -1 -2/3/4 -3//5 \\\n 1\r\n";
    read_prefixes(text, [](std::string_view prefix) { return parse_obj(prefix, "cut"); });
}

TEST(Obj, TheLocaleHasNoSay) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    const QuadMesh mesh = shapes::from_faces({{0.5f, 0, 0}, {1.25f, 0, 0}, {0, 1e6f, 0}}, {{0, 1, 2}});
    const std::string text = obj_text(mesh);
    for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE", ""})
        if (std::setlocale(LC_ALL, locale)) break;
    EXPECT_EQ(obj_text(mesh), text);
    expect_same_mesh(*parse_obj(text, "a.obj"), mesh);
    std::setlocale(LC_ALL, before.c_str());
}

}  // namespace
}  // namespace sinew
