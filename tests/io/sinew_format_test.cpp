// The native format: whatever is valid goes through load and save unchanged; whatever is not is refused with
// its place.
#include "sinew/io/sinew_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "fixed_seed.h"

namespace sinew {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

std::string saved(const std::string& text) {
    Result<ReadSkeleton> read = parse_sinew(text);
    if (!read) return read.error().text();
    return print_sinew(read->document).value().text;
}

std::string with_nodes(const std::string& nodes) {
    return R"({"format": "sinew", "version": 1, "nodes": [)" + nodes + "]}";
}

const char* every_key = R"({
  "format": "sinew", "version": 1, "unit": "mm", "blend": 0.5,
  "density": {"aspect": 2, "edge_length": 0.1, "grade": 1}, "author": {"name": "A", "tags": []},
  "symmetry": {"radial": {"axis": "z", "count": 8, "phase": 0}, "note": 1},
  "nodes": [
    {"id": 7, "position": [0, -0.0, 1e-300], "radius": 0.1, "name": "hip ❤ \"q\"", "type": "sphere", "colour": [1, 2]},
    {"id": 0, "parent": 7, "position": [0, 0, 2], "radius": 3, "type": "cube", "size": [0.6, 0.6, 0.4],
     "roll": 30, "joint": "sharp", "section": "rectangular"},
    {"id": 9, "parent": 0, "position": [1, 0, 2], "radius": 3, "joint": 2.5, "scale": [1, 1], "roll": 0, "name": ""},
    {"id": 8, "parent": 0, "position": [0, 1, 2], "radius": 3, "joint": "smooth", "scale": [2, 1, 1],
     "rotation": [0, 0, 0.6, 0.8], "section": "round", "joint2": null},
    {"id": 4, "position": [9, 9, 9], "radius": 1, "joint": 0, "blend": 0}],
  "links": [[7, 9], [8, 9]]})";

TEST(SinewFormat, ReadsEveryKey) {
    const Document d = parse_sinew(every_key).value().document;
    EXPECT_EQ(d.unit, "mm");
    EXPECT_EQ(d.blend, 0.5);
    EXPECT_EQ(d.density, (Density{.aspect = 2, .edge_length = 0.1}));
    EXPECT_EQ(d.nodes[4].blend, 0);
    EXPECT_FALSE(d.nodes[0].blend);
    EXPECT_EQ(d.symmetry, (Symmetry{Symmetry::Kind::radial, 2, 8}));
    ASSERT_EQ(d.nodes.size(), 5u);
    EXPECT_EQ(d.nodes[0].id, 7);
    EXPECT_EQ(d.nodes[0].parent, -1);
    EXPECT_EQ(d.nodes[0].position.z(), 1e-300);
    EXPECT_TRUE(std::signbit(d.nodes[0].position.y()));
    EXPECT_EQ(d.nodes[1].parent, 0);
    EXPECT_EQ(d.nodes[1].type, NodeType::cube);
    EXPECT_EQ(d.nodes[1].size, Vec3(0.6, 0.6, 0.4));
    EXPECT_EQ(d.nodes[1].roll, 30);
    EXPECT_EQ(d.nodes[1].joint, infinitely_sharp);
    EXPECT_EQ(d.nodes[1].section, Section::rectangular);
    EXPECT_EQ(d.nodes[2].joint, 2.5);
    EXPECT_EQ(d.nodes[3].scale[0], 2);
    EXPECT_EQ(d.nodes[3].rotation->coeffs(), Eigen::Vector4d(0, 0, 0.6, 0.8));
    EXPECT_THAT(d.names, ElementsAre("hip ❤ \"q\"", "", "", "", ""));
    EXPECT_EQ(json::parse(d.extras[0]), json::parse(R"({"colour": [1, 2]})"));
    EXPECT_THAT(d.links, ElementsAre(std::array{0, 2}, std::array{3, 2}));
}

TEST(SinewFormat, RefusesABlendAndADensityOutOfRange) {
    for (const auto& [key, path] :
         {std::pair(R"("blend": -1)", "/blend"), std::pair(R"("blend": 5)", "/blend"),
          std::pair(R"("density": 2)", "/density"),
          std::pair(R"("density": {"aspect": 0.5})", "/density/aspect"),
          std::pair(R"("density": {"edge_length": 0})", "/density/edge_length")}) {
        const auto read =
            parse_sinew(std::string(R"({"format": "sinew", "version": 1, )") + key + R"(, "nodes": []})");
        ASSERT_FALSE(read) << key;
        EXPECT_EQ(read.error().path, path);
    }
    EXPECT_FALSE(parse_sinew(with_nodes(R"({"id": 1, "position": [0, 0, 0], "radius": 1, "blend": 4.5})")));
}

TEST(SinewFormat, SavingKeepsEveryKey) { EXPECT_EQ(json::parse(saved(every_key)), json::parse(every_key)); }

TEST(SinewFormat, WhatAProgramMadeIsWrittenWithoutBeingAskedFor) {
    Document made{.unit = "mm"};
    made.nodes.push_back(
        {.id = 4, .position = Vec3(1, 2, 3), .radius = 2, .scale = {1, 2, 3}, .roll = 15, .joint = 2.5});
    made.nodes.push_back(
        {.id = 5, .parent = 0, .position = Vec3(1, 2, 9), .radius = 1, .section = Section::rectangular});
    const Document read = parse_sinew(print_sinew(made).value().text).value().document;
    EXPECT_EQ(read.unit, "mm");
    ASSERT_EQ(read.nodes.size(), 2u);
    EXPECT_EQ(read.nodes[0].scale, made.nodes[0].scale);
    EXPECT_EQ(read.nodes[0].roll, 15);
    EXPECT_EQ(read.nodes[0].joint, 2.5);
    EXPECT_EQ(read.nodes[1].section, Section::rectangular);
}

TEST(SinewFormat, SavingTwiceGivesTheSameBytes) { EXPECT_EQ(saved(saved(every_key)), saved(every_key)); }

TEST(SinewFormat, TheTextIsANodeALine) {
    Document d;
    d.nodes.resize(2);
    d.nodes[0].id = 1;
    d.nodes[1].id = 2;
    d.nodes[1].parent = 0;
    d.nodes[1].position = {0, 0.5, 1e22};
    d.nodes[1].type = NodeType::cone;
    EXPECT_EQ(print_sinew(d).value().text, R"({
  "format": "sinew",
  "version": 1,
  "nodes": [
    {"id": 1, "position": [0, 0, 0], "radius": 1},
    {"id": 2, "parent": 1, "position": [0, 0.5, 1e+22], "radius": 1, "type": "cone"}
  ]
}
)");
}

TEST(SinewFormat, IntegersMayBeWrittenWithAPoint) {
    const Document d = parse_sinew(R"({"version": 1.0, "format": "sinew", "nodes": [
        {"id": 1.0, "position": [0, 0, 0], "radius": 1}, {"id": 2, "parent": 1.0, "position": [0, 0, 1], "radius": 1}]})")
                           .value()
                           .document;
    EXPECT_EQ(d.nodes[1].parent, 0);
}

TEST(SinewFormat, AByteOrderMarkIsSkipped) { EXPECT_TRUE(parse_sinew("\xEF\xBB\xBF" + with_nodes(""))); }

TEST(SinewFormat, AnEditorMayLoadWhatMakesNoSenseYet) {
    const std::string text = with_nodes(R"({"id": 1, "position": [0, 0, 0], "radius": -1, "type": "cone"})");
    EXPECT_FALSE(parse_sinew(text));
    EXPECT_TRUE(parse_sinew(text, {.validate = false}));
}

TEST(SinewFormat, UnknownKeysOfASymmetryGoWithItsKind) {
    Document d = parse_sinew(every_key).value().document;
    d.symmetry = {Symmetry::Kind::mirror, 1, 1};
    const json written = json::parse(print_sinew(d).value().text);
    EXPECT_EQ(written["symmetry"], json::parse(R"({"mirror": "y", "note": 1})"));
    EXPECT_TRUE(parse_sinew(written.dump()));
}

TEST(SinewFormat, WhatJsonCannotSayIsNotWritten) {
    Document d;
    d.nodes.resize(1);
    d.nodes[0].radius = std::nan("");
    EXPECT_THAT(print_sinew(d).error().text(), HasSubstr("the radius of node 0 is not finite"));
    d.nodes[0].radius = 1;
    d.links = {{0, 3}};
    EXPECT_THAT(print_sinew(d).error().text(), HasSubstr("names a node that does not exist"));
}

TEST(SinewFormat, ErrorsNameTheLine) {
    const std::string text =
        "{\"format\": \"sinew\", \"version\": 1,\n\"nodes\": [\n{\"id\": 3, \"position\": [0, 0, 0], "
        "\"radius\":\n-1\n}]}";
    const Error error = parse_sinew(text).error();
    EXPECT_EQ(error.line, 4);
    EXPECT_EQ(error.path, "/nodes/0/radius");
    EXPECT_EQ(error.node, 3);
    EXPECT_EQ(parse_sinew("{\"a\": 1,\n  \"a\": 2}").error().line, 2);
    EXPECT_EQ(parse_sinew("{\n\"a\" 1}").error().column, 5);
}

TEST(SinewFormat, ANewerVersionIsRefusedWhateverElseItSays) {
    EXPECT_THAT(
        parse_sinew(R"({"format": "sinew", "version": 2, "nodes": "elsewhere"})").error().text(),
        HasSubstr("the document is of version 2, and this program knows version 1; get a newer Sinew"));
}

TEST(SinewFormat, DeepNestingIsRefused) {
    const std::string deep = std::string(1000000, '[');
    EXPECT_THAT(parse_sinew(deep).error().text(), HasSubstr("more than 100 deep"));
    EXPECT_THAT(parse_sinew(with_nodes("{\"x\":" + deep)).error().path,
                testing::StartsWith("/nodes/0/x/0/0"));
    const std::string bearable = std::string(97, '[') + std::string(97, ']');
    EXPECT_TRUE(
        parse_sinew(with_nodes(R"({"id": 1, "position": [0, 0, 0], "radius": 1, "x": )" + bearable + "}")));
}

TEST(SinewFormat, NoTruncatedDocumentIsTaken) {
    const std::string text = saved(every_key);
    for (std::size_t length = 1; length + 2 < text.size(); ++length) {
        Result<ReadSkeleton> read = parse_sinew(text.substr(0, length));
        ASSERT_FALSE(read) << length;
        ASSERT_GT(read.error().line, 0) << length;
    }
}

// --- any valid document, made at random as JSON

using rc::gen::arbitrary;
using rc::gen::element;
using rc::gen::inRange;

double any_number() {
    switch (*inRange(0, 4)) {
        case 0:
            return *inRange(-1000, 1000);
        case 1:
            return *inRange(-1000, 1000) / 8.0;
        case 2:
            return std::ldexp(*inRange(-100000, 100000) / 99991.0, *inRange(-60, 60));
        default:
            return -0.0;
    }
}
double positive() { return std::ldexp(1 + *inRange(0, 100000) / 99991.0, *inRange(-30, 30)); }
json list(std::size_t size, double (*make)()) {
    json numbers = json::array();
    while (numbers.size() < size) numbers.push_back(make());
    return numbers;
}
bool maybe() { return *inRange(0, 3) == 0; }
std::string word() {
    return *rc::gen::container<std::string>(element('a', '"', '\\', '\n', '/', '~', ' ', '\x01'));
}

json unknown() {
    return *element<json>(nullptr, 1, -1, 0.5, "text", json::array({1, json::object()}),
                          json{{"a", {{"b", true}}}}, std::numeric_limits<std::uint64_t>::max());
}
void add_unknown(json& object) {
    for (int i = *inRange(0, 3); i > 0; --i) object["x-" + word()] = unknown();
}

json any_node(std::int64_t id) {
    json node{{"id", id}, {"position", list(3, any_number)}, {"radius", positive()}};
    if (maybe()) node["name"] = word();
    if (maybe()) node["type"] = *element("sphere", "cube", "ball");
    if (maybe()) node["section"] = *element("round", "rectangular");
    if (maybe()) node["scale"] = maybe() ? json::array({1, 1}) : list(*inRange(2, 4), positive);
    if (maybe()) node["size"] = list(3, positive);
    if (maybe()) node["roll"] = any_number();
    if (maybe()) node["rotation"] = json::array({0.0, 0.6, -0.8, 0.0});
    if (maybe()) node["joint"] = *element<json>("smooth", "sharp", 0, 0.0, 2.5, 10, 1e9);
    add_unknown(node);
    return node;
}

json any_document() {
    json document{{"format", "sinew"}, {"version", 1}, {"nodes", json::array()}};
    if (maybe()) document["unit"] = *element("", "m", "um");
    if (maybe())
        document["symmetry"] = json{{"mirror", *element("x", "y", "z")}};
    else if (maybe())
        document["symmetry"] = json{{"radial", {{"axis", "y"}, {"count", *inRange(2, 1000)}}}};
    if (document.contains("symmetry")) add_unknown(document["symmetry"]);
    add_unknown(document);
    json& nodes = document["nodes"];
    const int count = *inRange(0, 12);
    const std::int64_t base = *element<std::int64_t>(0, 1, 1000000000000);
    for (int i = 0; i < count; ++i) {
        nodes.push_back(any_node(base + 7 * ((i * 5) % 12)));  // unique, in no order
        if (i > 0 && !maybe()) nodes[i]["parent"] = nodes[*inRange(0, i)]["id"];
    }
    if (maybe()) document["links"] = json::array();
    if (count >= 3 && !nodes[2].contains("parent"))
        document["links"].push_back({nodes[2]["id"], nodes[0]["id"]});
    return document;
}

RC_GTEST_PROP(SinewFormatProperty, AnyValidDocumentGoesThroughLoadAndSaveUnchanged, ()) {
    const json document = any_document();
    const std::string text = saved(document.dump());
    RC_LOG() << document.dump() << '\n' << text;
    RC_ASSERT(json::parse(text) == document);
}

}  // namespace
}  // namespace sinew
