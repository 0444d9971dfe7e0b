#include "document/fields.h"

#include <gmock/gmock.h>

#include <set>

#include "document/delta.h"
#include "sinew/skeleton/validate.h"

namespace sinew::modeler {
namespace {

using testing::ElementsAre;

/// A root, a limb of two, and a cube, a ball and a plain tip beside each other at its end; a lone node.
Document document_of_all() {
    Document document;
    for (const auto& [parent, type] : {std::pair{-1, NodeType::sphere},
                                       {0, NodeType::sphere},
                                       {1, NodeType::cube},
                                       {1, NodeType::ball},
                                       {1, NodeType::sphere},
                                       {-1, NodeType::sphere}})
        append_node(
            document,
            {.id = -1, .parent = parent, .position = Vec3::Random() * 5, .radius = 0.5, .type = type});
    return document;
}

/// The ids of the fields that mean something for a node.
bool is_relevant(const Document& document, std::int32_t node, const Field& field) {
    return relevant_to_all(document, {&node, 1}, field);
}

std::set<std::string> relevant(const Document& document, std::int32_t node) {
    std::set<std::string> ids;
    for (const Field& field : fields())
        if (is_relevant(document, node, field)) ids.insert(field.id);
    return ids;
}

TEST(Fields, have_an_id_of_their_own_and_say_what_they_are) {
    std::set<std::string> ids;
    for (const Field& field : fields()) {
        EXPECT_TRUE(ids.insert(field.id).second) << field.id;
        EXPECT_EQ(find_field(field.id), &field);
        EXPECT_NE(std::string(field.group), "");
        EXPECT_GT(std::string(field.tip).size(), 5u);
        EXPECT_LT(field.least, field.most);
    }
    EXPECT_EQ(find_field("no such field"), nullptr);
}

TEST(Fields, what_is_put_is_what_one_gets) {
    const Document document = document_of_all();
    for (const Field& field : fields())
        for (std::int32_t node = 0; node < 6; ++node) {
            if (!is_relevant(document, node, field)) continue;
            const Document changed = with_value(document, std::span(&node, 1), field, 0.75);
            EXPECT_NEAR(field.get(changed, node), 0.75, 1e-9) << field.id;
            EXPECT_TRUE(validate(changed)) << field.id;
            EXPECT_EQ(DocumentDelta(document, changed).changed_nodes(), 1u) << field.id;
        }
}

TEST(Fields, values_stay_within_their_limits) {
    const Document document = document_of_all();
    const std::int32_t cube = 2;
    for (const Field& field : fields()) {
        if (!is_relevant(document, cube, field)) continue;
        for (const double wild : {-1e30, 1e30}) {
            const Document changed = with_value(document, std::span(&cube, 1), field, wild);
            EXPECT_TRUE(validate(changed)) << field.id << " " << wild;
        }
    }
}

TEST(Fields, many_nodes_share_a_value_or_have_none) {
    Document document = document_of_all();
    const std::vector<std::int32_t> nodes{1, 2, 4};
    const Field& radius = *find_field("radius");
    EXPECT_EQ(common_value(document, nodes, radius), 0.5);
    document.nodes[4].radius = 2;
    EXPECT_EQ(common_value(document, nodes, radius), std::nullopt);
    EXPECT_EQ(common_value(document, {}, radius), std::nullopt);
    document = with_value(document, nodes, radius, 3);
    EXPECT_EQ(common_value(document, nodes, radius), 3);
    EXPECT_EQ(document.nodes[0].radius, 0.5);
}

TEST(Fields, each_type_has_those_that_shape_it) {
    const Document document = document_of_all();
    const auto has = [&](std::int32_t node, const char* id) { return relevant(document, node).contains(id); };
    for (std::int32_t node = 0; node < 6; ++node)
        for (const char* id : {"x", "y", "z", "radius", "roll", "joint"}) EXPECT_TRUE(has(node, id)) << id;
    const std::int32_t limb = 1, cube = 2, ball = 3, lone = 5;
    EXPECT_TRUE(has(cube, "size_x"));
    EXPECT_FALSE(has(limb, "size_x"));
    EXPECT_FALSE(has(cube, "width"));
    EXPECT_TRUE(has(limb, "width"));
    // A third axis is for what is no tube: a ball, or a node without bones.
    EXPECT_TRUE(has(ball, "depth"));
    EXPECT_TRUE(has(lone, "depth"));
    EXPECT_FALSE(has(limb, "depth"));
    // A leaf's box is turned by its bone.
    EXPECT_FALSE(has(cube, "turn_x"));
    EXPECT_TRUE(relevant_to_all(document, std::vector<std::int32_t>{limb, ball}, *find_field("width")));
    EXPECT_FALSE(relevant_to_all(document, std::vector<std::int32_t>{limb, cube}, *find_field("width")));
}

TEST(Fields, a_cube_keeps_the_extents_that_were_not_touched) {
    Document document = document_of_all();
    const std::int32_t cube = 2;
    document = with_value(document, std::span(&cube, 1), *find_field("size_y"), 3);
    EXPECT_EQ(*document.nodes[cube].size, Vec3(1, 3, 1));  // the default is twice the radius
}

TEST(Fields, angles_are_those_of_the_rotation) {
    for (const Vec3& angles : {Vec3(0, 0, 0), Vec3(30, 0, 0), Vec3(10, 20, 30), Vec3(-170, 80, 5)}) {
        Node node;
        node.rotation = from_angles(angles);
        EXPECT_LT((angles_of(node) - angles).norm(), 1e-9) << angles.transpose();
    }
    Node node;
    node.rotation = from_angles(Vec3(40, 90, 0));  // there x and z turn about the same axis
    EXPECT_LT(from_angles(angles_of(node)).angularDistance(*node.rotation), 1e-6);
    // x first, then y, then z, about the world's axes: x goes to z by y, and stays there.
    EXPECT_TRUE((from_angles(Vec3(0, -90, 0)) * Vec3::UnitX()).isApprox(Vec3::UnitZ()));
}

TEST(Fields, ten_is_as_sharp_as_it_gets) {
    Document document = document_of_all();
    const std::int32_t node = 1;
    const Field& joint = *find_field("joint");
    document = with_value(document, std::span(&node, 1), joint, 10);
    EXPECT_EQ(document.nodes[node].joint, infinitely_sharp);
    EXPECT_EQ(joint.get(document, node), 10);
}

}  // namespace
}  // namespace sinew::modeler
