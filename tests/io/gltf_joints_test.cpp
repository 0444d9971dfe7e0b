#include "sinew/io/gltf_joints.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "sinew/skeleton/validate.h"

namespace sinew {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

/// An arm in glTF's axes (y up): a hip that is no joint, lifted and turned by a quarter about z; joints 2 ->
/// 1, with a helper between them, and 0 as the hand at its end.
const char* const arm =
    R"({"asset": {"version": "2.0"}, "skins": [{"joints": [1, 2]}, {"joints": [0, 2]}], "nodes": [
    {"name": "hand", "translation": [0, 2, 0]},
    {"name": "fore", "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,1,3,1], "children": [0]},
    {"name": "upper", "children": [4], "scale": [1, 2, 1]},
    {"name": "hip", "children": [2], "translation": [0, 10, 0], "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476]},
    {"name": "helper", "children": [1], "translation": [0, 1, 0]}]})";

TEST(GltfJoints, JointsStandWhereTheTransformsPutThem) {
    const ReadSkeleton read = parse_gltf(arm).value();
    const Document& d = read.document;
    EXPECT_TRUE(validate(d));
    EXPECT_EQ(d.unit, "m");
    EXPECT_THAT(d.names, ElementsAre("hand", "fore", "upper"));
    ASSERT_THAT(d.nodes, SizeIs(3));
    EXPECT_EQ(d.nodes[0].parent, 1);
    EXPECT_EQ(d.nodes[1].parent, 2);
    EXPECT_EQ(d.nodes[2].parent, -1);
    // Local y is -x in the world, doubled below the upper arm; our z is glTF's y, our -y its z.
    EXPECT_TRUE(d.nodes[2].position.isApprox(Vec3(0, 0, 10)));
    EXPECT_TRUE(d.nodes[1].position.isApprox(Vec3(-4, -3, 10)));
    EXPECT_TRUE(d.nodes[0].position.isApprox(Vec3(-8, -3, 10)));
}

TEST(GltfJoints, RadiiAreAFifthOfTheBones) {
    const ReadSkeleton read = parse_gltf(arm).value();
    EXPECT_DOUBLE_EQ(read.document.nodes[0].radius, 4 / 5.0);
    EXPECT_DOUBLE_EQ(read.document.nodes[1].radius, (4 + 5) / 2.0 / 5);
    EXPECT_THAT(read.warnings.at(0).message, HasSubstr("3 nodes without a radius"));
    EXPECT_FALSE(parse_gltf(arm, {.strict = true}));
}

TEST(GltfJoints, WithoutASkinTheSceneIsTheSkeleton) {
    std::string text = arm;
    text.replace(text.find("\"skins\""), 7, "\"scenes\": [{\"nodes\": [4]}], \"x\"");
    const Document d = parse_gltf(text).value().document;
    EXPECT_THAT(d.names, ElementsAre("hand", "fore", "helper"));
}

TEST(GltfJoints, NodesAboveAndBesideTheJointsAreNoJoints) {
    const Document d = parse_gltf(R"({"asset": {"version": "2.0"}, "skins": [{"joints": [2, 3]}], "nodes": [
        {"children": [1, 4]}, {"children": [2]}, {"children": [3]}, {"translation": [0, 1, 0]}, {"mesh": 0}]})")
                           .value()
                           .document;
    ASSERT_THAT(d.nodes, SizeIs(2));
    EXPECT_EQ(d.nodes[0].parent, -1);
    EXPECT_EQ(d.nodes[1].parent, 0);
}

std::string binary(const std::string& json) {
    auto word = [](std::uint32_t value) {
        std::string bytes;
        for (int k = 0; k < 4; ++k) bytes += static_cast<char>(value >> (8 * k) & 0xff);
        return bytes;
    };
    const auto size = static_cast<std::uint32_t>(json.size());
    return "glTF" + word(2) + word(20 + size) + word(size) + "JSON" + json;
}

TEST(GltfJoints, TheBinaryFormIsTheSame) {
    const Document text = parse_gltf(arm).value().document, bytes = parse_gltf(binary(arm)).value().document;
    ASSERT_EQ(text.nodes.size(), bytes.nodes.size());
    for (std::size_t i = 0; i < text.nodes.size(); ++i)
        EXPECT_EQ(text.nodes[i].position, bytes.nodes[i].position);
}

TEST(GltfJoints, NoTruncatedFileIsTaken) {
    const std::string text = arm, bytes = binary(arm);
    for (std::size_t length = 0; length < text.size(); ++length)
        ASSERT_FALSE(parse_gltf(text.substr(0, length))) << length;
    for (std::size_t length = 0; length < bytes.size(); ++length)
        ASSERT_FALSE(parse_gltf(bytes.substr(0, length))) << length;
}

}  // namespace
}  // namespace sinew
