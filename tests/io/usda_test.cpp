#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "io/mesh_testing.h"
#include "sinew/io/usda_reader.h"
#include "sinew/io/usda_writer.h"
#include "sinew/mesh/measure.h"

namespace sinew {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

RC_GTEST_PROP(Usda, WhatIsWrittenIsReadBackBitForBit, ()) {
    const QuadMesh mesh = *any_mesh();
    const Result<QuadMesh> read = parse_usda(usda_text(mesh), "m.usda");
    RC_ASSERT(read.has_value());
    expect_same_mesh(*read, mesh);
    RC_ASSERT(!testing::Test::HasFailure());
}

TEST(Usda, CreasesAndCornersComeBack) {
    QuadMesh mesh = shapes::cube();
    mesh.features.creases = {{{0, 1}, 2.5f}, {{4, 5}, std::numeric_limits<float>::infinity()}};
    mesh.features.corners = {3, 6};
    const QuadMesh read = *parse_usda(usda_text(mesh), "m.usda");
    ASSERT_EQ(read.features.creases.size(), 2u);
    EXPECT_EQ(read.features.creases[0].edge, (MeshEdge{0, 1}));
    EXPECT_EQ(read.features.creases[0].sharpness, 2.5f);
    EXPECT_EQ(read.features.creases[1].sharpness, 10) << "which is what USD has for infinitely sharp";
    EXPECT_THAT(read.features.corners, ElementsAre(3, 6));
}

TEST(Usda, TheTextIsWhatUsdExpects) {
    EXPECT_EQ(usda_text(shapes::from_faces({{0, 0, 0}, {1.5f, 0, 0}, {0, 1, 1e-7f}}, {{0, 1, 2}}), 0.01),
              R"(#usda 1.0
(
    defaultPrim = "sinew"
    metersPerUnit = 0.01
    upAxis = "Z"
)

def Mesh "sinew"
{
    float3[] extent = [(0, 0, 0), (1.5, 1, 1e-07)]
    int[] faceVertexCounts = [3]
    int[] faceVertexIndices = [0, 1, 2]
    point3f[] points = [(0, 0, 0), (1.5, 0, 0), (0, 1, 1e-07)]
    uniform token orientation = "rightHanded"
    uniform token subdivisionScheme = "catmullClark"
}
)");
}

/// One file with much of what others write round a mesh.
const char* const elaborate = R"(#usda 1.0
(
    """A comment, with "quotes" and a } bracket"""
    customLayerData = { dictionary nested = { string note = "( [ {" } }
    startTimeCode = 0
    upAxis = "Z"
)
# a comment )
class Mesh "_class_template" { point3f[] points = [(9, 9, 9)] }
def Xform "World" ( prepend references = @./other.usda@</A> kind = "component" variants = { string look = "red" } )
{
    def Scope "Materials" { def Material "clay" { token outputs:surface.connect = </World/Materials/clay/s.outputs:surface> } }
    def Mesh "square" (
        prepend apiSchemas = ["MaterialBindingAPI"]
        doc = 'single { quotes'
    )
    {
        custom string userProperties:note = "say \"hi\" } there"
        asset file = @@@odd@name@@@
        uniform bool doubleSided = 1
        rel material:binding = </World/Materials/clay>
        float3[] extent = [(0, 0, 0), (1, 1, 0)]
        int[] faceVertexCounts = [4];
        int[] faceVertexIndices = [0, 1,
            2, 3,]
        point3f[] points.timeSamples = {
            0: [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)],
            24: [(5, 5, 5), (6, 5, 5), (6, 6, 5), (5, 6, 5)],
        }
        texCoord2f[] primvars:st = [(0, 0), (inf, -inf)] ( interpolation = "vertex" )
        normal3f[] normals = None
        int[] creaseIndices = [0, 1, 2, 3, 0]
        int[] creaseLengths = [3, 2]
        float[] creaseSharpnesses = [1, 2, 4]
        int[] cornerIndices = [1, 2]
        float[] cornerSharpnesses = [10, 3]
        float3 xformOp:translate = (0, 0, 1)
        uniform token[] xformOpOrder = ["xformOp:translate"]
        variantSet "look" = { "red" { point3f[] points = [] } }
    }
    over "left" ( active = false ) { def Mesh "hidden" { int[] faceVertexCounts = [9] } }
    def Mesh "turned"
    {
        uniform token orientation = "leftHanded"
        int[] faceVertexCounts = [3]
        int[] faceVertexIndices = [0, 1, 2]
        point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
    }
    double3 xformOp:scale = (2, 2, 2)
    float xformOp:rotateZ:spin = 90
    double3 xformOp:translate:pivot = (1, 0, 0)
    uniform token[] xformOpOrder = ["xformOp:translate:pivot", "xformOp:rotateZ:spin", "!invert!xformOp:translate:pivot", "xformOp:scale"]
}
)";

TEST(Usda, ReadsWhatOthersWrite) {
    const Result<QuadMesh> mesh = parse_usda(elaborate, "e.usda");
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ(mesh->corners, (std::vector<std::uint32_t>{0, 1, 2, 3, 6, 5, 4}));
    ASSERT_EQ(mesh->vertex_count(), 7u);
    // Up by 1, twice as large, then a quarter turn about (1, 0): x, y become 1 - y, x - 1.
    const Vec3f expected[] = {{1, -1, 2}, {1, 1, 2}, {-1, 1, 2}, {-1, -1, 2},
                              {1, -1, 0}, {1, 1, 0}, {-1, -1, 0}};
    for (std::size_t v = 0; v < 7; ++v) EXPECT_LT((mesh->positions[v] - expected[v]).norm(), 1e-6f) << v;
    ASSERT_EQ(mesh->features.creases.size(), 3u);
    EXPECT_EQ(mesh->features.creases[1].edge, (MeshEdge{1, 2}));
    EXPECT_EQ(mesh->features.creases[1].sharpness, 2);
    EXPECT_EQ(mesh->features.creases[2].edge, (MeshEdge{3, 0}));
    EXPECT_THAT(mesh->features.corners, ElementsAre(1)) << "a corner of sharpness 3 is none that never moves";
}

std::string cube_with(const std::string& properties, const std::string& layer = "(upAxis = \"Z\")") {
    std::string text = usda_text(shapes::cube());
    text.replace(text.find('('), text.find(')') - text.find('(') + 1, layer);
    return text.insert(text.rfind('}'), properties);
}

TEST(Usda, TransformsOfAllKinds) {
    auto box = [](const std::string& operation) {
        const std::string name =
            operation.substr(operation.find("xformOp"), operation.find(" =") - operation.find("xformOp"));
        const auto mesh = parse_usda(
            cube_with(operation + "\nuniform token[] xformOpOrder = [\"" + name + "\"]\n"), "t.usda");
        EXPECT_TRUE(mesh) << mesh.error().text();
        EXPECT_TRUE(validate(*mesh).solid()) << operation;
        return measure(*mesh);
    };
    auto expect_box = [&](const std::string& operation, const Vec3& low, const Vec3& high) {
        const Measures m = box(operation);
        EXPECT_LT((m.low - low).norm() + (m.high - high).norm(), 1e-6)
            << operation << ": " << m.low.transpose();
    };
    expect_box("double3 xformOp:scale = (-2, 1, 1)", {-2, 0, 0}, {0, 1, 1});
    expect_box("float xformOp:rotateX = 90", {0, -1, 0}, {1, 0, 1});
    expect_box("float3 xformOp:rotateXYZ = (90, 0, 90)", {0, 0, 0},
               {1, 1, 1});  // y to z, then x to y, y to -x
    expect_box("float3 xformOp:rotateZYX = (90, 0, 90)", {-1, -1, 0}, {0, 0, 1});
    expect_box("quatf xformOp:orient = (0, 0, 0, 1)", {-1, -1, 0}, {0, 0, 1});
    expect_box("matrix4d xformOp:transform = ( (1, 0, 0, 0), (0, 0, 1, 0), (0, -1, 0, 0), (3, 4, 5, 1) )",
               {3, 3, 5}, {4, 4, 6});
    EXPECT_THAT(
        error_text(parse_usda(cube_with("uniform token[] xformOpOrder = [\"xformOp:warp\"]\n"), "t.usda")),
        HasSubstr("a transform that cannot be read"));
}

TEST(Usda, YIsUpWhereTheFileDoesNotSayOtherwise) {
    for (const char* layer : {"(upAxis = \"Y\")", "()", ""}) {
        const Measures m = measure(*parse_usda(cube_with("", layer), "y.usda"));
        EXPECT_EQ(m.low, Vec3(0, -1, 0)) << layer;
        EXPECT_EQ(m.high, Vec3(1, 0, 1)) << layer;
        EXPECT_NEAR(m.volume, 1, 1e-12);
    }
}

TEST(Usda, MalformedFilesAreRefusedWithTheirPlace) {
    const std::string mesh = "#usda 1.0\ndef Mesh \"m\" {\n";
    const std::string points = "point3f[] points = [(0,0,0), (1,0,0), (0,1,0)]\n";
    const std::string faces = "int[] faceVertexCounts = [3]\nint[] faceVertexIndices = [0, 1, 2]\n";
    const std::pair<std::string, std::string> cases[] = {
        {"", "bad.usda:1: this is no USD text"},
        {"PXR-USDC\1\2", "turn it into text with usdcat"},
        {"#usda 1.0\n", "bad.usda: there is no mesh in it"},
        {mesh, "bad.usda:3:1: the file ends too early"},
        {mesh + ")", "bad.usda:3:1: a bracket that closes nothing"},
        {mesh + "int[] a = [1, 2", "bad.usda:3:16: the file ends too early"},
        {mesh + "string s = \"open\n}", "bad.usda:3:12: this cannot be read as USD text"},
        {mesh + "int a = ?\n}", "bad.usda:3:9: this cannot be read as USD text"},
        {"#usda 1.0\ndef Mesh m {}", "bad.usda:2:10: a prim has no name"},
        {"#usda 1.0\ndef Mesh \"m\" = 3", "bad.usda:2:14: a prim has no body"},
        {mesh + points + "int[] faceVertexCounts = [3]\nint[] faceVertexIndices = [0, 1, 3]\n}",
         "bad.usda:6:1: in the mesh that ends here: a face names point 3, but there are 3"},
        {mesh + points + "int[] faceVertexCounts = [3]\nint[] faceVertexIndices = [0, 1]\n}",
         "fewer than faceVertexCounts"},
        {mesh + points + "int[] faceVertexCounts = [3]\nint[] faceVertexIndices = [0, 1, 2, 0]\n}",
         "more than faceVertexCounts"},
        {mesh + points + "int[] faceVertexCounts = [2]\nint[] faceVertexIndices = [0, 1]\n}",
         "a face of 2 corners"},
        {mesh + points + "int[] faceVertexCounts = [1.5]\n}",
         "bad.usda:4:27: this is no number that fits here"},
        {mesh + "point3f[] points = [(0,0,0), (1,0)]\n}", "points do not come in threes"},
        {mesh + "point3f[] points = [(0,0,0), (1,inf,0)]\n}", "point 1 is not finite"},
        {mesh + "point3f[] points = [(0,0,1e39)]\n}", "point 0 is not finite"},
        {mesh + points + faces + "int[] creaseIndices = [0]\nint[] creaseLengths = [1]\n}",
         "a crease of no edge"},
        {mesh + points + faces +
             "int[] creaseIndices = [0, 9]\nint[] creaseLengths = [2]\nfloat[] creaseSharpnesses = [1]\n}",
         "a crease names point 9"},
        {mesh + points + faces + "int[] creaseIndices = [0, 1]\nint[] creaseLengths = [2]\n}",
         "creaseSharpnesses are neither"},
        {mesh + points + faces + "int[] cornerIndices = [0]\n}", "cornerSharpnesses are not one a corner"},
    };
    for (const auto& [text, message] : cases)
        EXPECT_THAT(error_text(parse_usda(text, "bad.usda")), HasSubstr(message)) << text;
}

TEST(Usda, PrimsStandInOneAnother) {
    // Meshes at every depth, moved once more by each prim round them; the places follow the prims in them. One is
    // put back into the world.
    const int deep = 150;
    const std::string triangle =
        "def Mesh \"m\" {\npoint3f[] points = [(0,0,0),(1,0,0),(0,1,0)]\nint[] faceVertexCounts = [3]\n"
        "int[] faceVertexIndices = [0,1,2]\n";
    std::string text = "#usda 1.0\n(upAxis = \"Z\")\n";
    for (int i = 0; i < deep; ++i) text += "def Xform \"x\" {\n" + triangle + "}\n";
    text += triangle +
            "double3 xformOp:translate = (0,0,7)\n"
            "uniform token[] xformOpOrder = [\"!resetXformStack!\", \"xformOp:translate\"]\n}\n";
    for (int i = 0; i < deep; ++i)
        text +=
            "double3 xformOp:translate = (2,0,0)\nuniform token[] xformOpOrder = "
            "[\"xformOp:translate\"]\n}\n";
    const QuadMesh mesh = parse_usda(text, "deep.usda").value();
    ASSERT_EQ(mesh.vertex_count(), 3u * (deep + 1));
    for (int i = 0; i < deep; ++i)
        EXPECT_EQ(mesh.positions[3 * static_cast<std::size_t>(i)],
                  Vec3f(2.0f * static_cast<float>(i + 1), 0, 0));
    EXPECT_EQ(mesh.positions[3 * std::size_t{deep}], Vec3f(0, 0, 7));
}

TEST(Usda, DeepNestingIsRefusedNotFollowed) {
    std::string text = "#usda 1.0\n";
    for (int i = 0; i < 100000; ++i) text += "def \"a\" {\n";
    EXPECT_THAT(error_text(parse_usda(text, "deep.usda")), HasSubstr("nested too deeply"));
}

TEST(Usda, NoPrefixOfAFileDoesHarm) {
    auto read = [](std::string_view prefix) { return parse_usda(prefix, "cut"); };
    EXPECT_LE(read_prefixes(usda_text(shapes::cube()), read), 1u) << "the last line end may be missing";
    EXPECT_LE(read_prefixes(elaborate, read), 1u);
}

}  // namespace
}  // namespace sinew
