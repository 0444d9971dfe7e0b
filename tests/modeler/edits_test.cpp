#include "document/edits.h"

#include <gmock/gmock.h>

#include "document/delta.h"
#include "sinew/skeleton/graph.h"
#include "sinew/skeleton/validate.h"

namespace sinew::modeler {
namespace {

using testing::ElementsAre;

/// A spine 0 - 1 - 2 and a limb 1 - 3.
Document limbs() {
    Document document;
    append_node(document, {.id = -1, .parent = -1, .position = Vec3(0, 0, 0), .radius = 1});
    append_node(document, {.id = -1, .parent = 0, .position = Vec3(0, 0, 4), .radius = 2});
    append_node(document, {.id = -1, .parent = 1, .position = Vec3(0, 0, 8), .radius = 1});
    append_node(document, {.id = -1, .parent = 1, .position = Vec3(4, 0, 4), .radius = 0.5});
    return document;
}

TEST(Edits, there_is_a_free_id_beside_the_highest_of_all) {
    Document document = limbs();
    document.nodes[1].id = std::numeric_limits<std::int64_t>::max();
    for (int i = 0; i < 3; ++i) append_node(document, {.id = -1, .parent = 0});
    EXPECT_TRUE(validate(document)) << validate(document).error().text();
}

TEST(Edits, a_document_starts_with_a_root_and_a_mirror) {
    const Document document = starting_document();
    EXPECT_TRUE(validate(document));
    EXPECT_EQ(document.nodes.size(), 1u);
    EXPECT_EQ(document.symmetry, (Symmetry{Symmetry::Kind::mirror, 0, 1}));
}

TEST(Edits, children_start_where_their_parents_are) {
    const Edited edit = add_children(limbs(), std::vector<std::int32_t>{2, 3});
    ASSERT_TRUE(validate(edit.document));
    EXPECT_THAT(edit.selection.nodes, ElementsAre(4, 5));
    EXPECT_EQ(edit.document.nodes[4].parent, 2);
    EXPECT_EQ(edit.document.nodes[5].position, limbs().nodes[3].position);
    EXPECT_EQ(edit.document.nodes[5].radius, 0.5);
}

TEST(Edits, a_tip_moves_on_to_the_child_drawn_out_of_it) {
    Document document = limbs();
    document.nodes[3].type = NodeType::cone;
    const Edited edit = add_children(document, std::vector<std::int32_t>{3});
    EXPECT_TRUE(validate(edit.document));
    EXPECT_EQ(edit.document.nodes[3].type, NodeType::sphere);
    EXPECT_EQ(edit.document.nodes[4].type, NodeType::cone);
}

TEST(Edits, a_node_on_a_bone_interpolates) {
    const Edited edit = insert_on_bone(limbs(), 0, 0.25);
    ASSERT_TRUE(validate(edit.document));
    const Node& node = edit.document.nodes[4];
    EXPECT_EQ(node.position, Vec3(0, 0, 1));
    EXPECT_EQ(node.radius, 1.25);
    EXPECT_EQ(node.parent, 0);
    EXPECT_EQ(edit.document.nodes[1].parent, 4);
}

TEST(Edits, a_node_on_a_link_keeps_the_cycle) {
    const Document document = toggle_link(limbs(), 2, 3);
    const std::int32_t link = static_cast<std::int32_t>(bones_of(document).size()) - 1;
    const Edited edit = insert_on_bone(document, link, 0.5);
    ASSERT_TRUE(validate(edit.document));
    EXPECT_EQ(edit.document.nodes[4].position, Vec3(2, 0, 6));
    EXPECT_EQ(count_graph(5, bones_of(edit.document)).cycles, 1);
    EXPECT_TRUE(are_joined(edit.document, 2, 4) && are_joined(edit.document, 4, 3));
    EXPECT_FALSE(are_joined(edit.document, 2, 3));
}

TEST(Edits, erasing_a_joint_keeps_its_limbs) {
    const Edited edit = erase_nodes(limbs(), selection_of(1));
    ASSERT_TRUE(validate(edit.document));
    EXPECT_EQ(edit.document.nodes[1].parent, 0);
    EXPECT_EQ(edit.document.nodes[2].parent, 0);
    EXPECT_EQ(count_graph(3, bones_of(edit.document)).components, 1);
    EXPECT_EQ(edit.selection.active, 0);
}

TEST(Edits, erasing_a_root_keeps_its_limbs_together) {
    Document document = limbs();
    document = erase_nodes(document, selection_of(0)).document;
    document = erase_nodes(document, selection_of(0)).document;  // two limbs are left
    EXPECT_TRUE(validate(document));
    EXPECT_EQ(count_graph(2, bones_of(document)).components, 1);
}

TEST(Edits, erasing_a_branch_takes_all_below) {
    const Edited edit = erase_branches(limbs(), selection_of(1));
    EXPECT_EQ(edit.document.nodes.size(), 1u);
    EXPECT_TRUE(erase_branches(limbs(), selection_of(0)).document.nodes.empty());
}

TEST(Edits, names_links_and_extras_follow_their_nodes) {
    Document document = rename(toggle_link(limbs(), 2, 3), 3, "hand");
    document.extras.assign(4, "");
    document.extras[2] = "{}";
    document = erase_nodes(document, selection_of(0)).document;
    EXPECT_THAT(document.names, ElementsAre("", "", "hand"));
    EXPECT_THAT(document.extras, ElementsAre("", "{}", ""));
    EXPECT_TRUE(are_joined(document, 1, 2));
}

TEST(Edits, a_copy_has_the_bones_of_what_was_copied) {
    const Edited edit =
        duplicate(toggle_link(limbs(), 2, 3), selection_of(std::vector<std::int32_t>{3, 2, 1}));
    ASSERT_TRUE(validate(edit.document));
    EXPECT_THAT(edit.selection.nodes, ElementsAre(4, 5, 6));
    EXPECT_EQ(edit.document.nodes[4].parent, 0);  // the copy of 1 hangs where 1 does
    EXPECT_EQ(edit.document.nodes[5].parent, 4);
    EXPECT_TRUE(are_joined(edit.document, 5, 6));
}

TEST(Edits, linking_twice_is_nothing) {
    const Document document = limbs();
    const Document linked = toggle_link(document, 0, 2);
    EXPECT_EQ(linked.links.size(), 1u);
    EXPECT_TRUE(same(toggle_link(linked, 2, 0), document));
    EXPECT_TRUE(same(toggle_link(document, 0, 1), document));  // a bone joins them already
    EXPECT_TRUE(same(toggle_link(document, 1, 1), document));
}

TEST(Edits, linking_two_trees_makes_one) {
    const Edited two = add_root(limbs(), Vec3(9, 0, 0), 1);
    const Document document = toggle_link(two.document, 3, 4);
    EXPECT_TRUE(validate(document));
    EXPECT_EQ(document.nodes[4].parent, 3);
    EXPECT_TRUE(document.links.empty());
}

TEST(Edits, nobody_is_their_own_ancestor) {
    const Document document = limbs();
    EXPECT_FALSE(may_reparent(document, 0, 3));
    EXPECT_FALSE(may_reparent(document, 1, 1));
    EXPECT_TRUE(same(reparent(document, 0, 3), document));
    EXPECT_EQ(reparent(document, 3, 2).nodes[3].parent, 2);
    EXPECT_EQ(reparent(document, 3, -1).nodes[3].parent, -1);
}

TEST(Edits, types_for_leaves_are_for_leaves_only) {
    const Document document = set_type(limbs(), std::vector<std::int32_t>{0, 1, 2, 3}, NodeType::cone);
    EXPECT_TRUE(validate(document));
    EXPECT_EQ(document.nodes[1].type, NodeType::sphere);
    EXPECT_EQ(document.nodes[2].type, NodeType::cone);
    EXPECT_EQ(set_type(limbs(), std::vector<std::int32_t>{1}, NodeType::cube).nodes[1].type, NodeType::cube);
}

TEST(Edits, extents_of_a_cube_grow_with_its_radius) {
    Document document = limbs();
    document.nodes[2].size = Vec3(1, 2, 3);
    document = scale_radii(document, std::vector<std::int32_t>{2}, 2);
    EXPECT_EQ(document.nodes[2].radius, 2);
    EXPECT_EQ(*document.nodes[2].size, Vec3(2, 4, 6));
    EXPECT_GT(scale_radii(document, std::vector<std::int32_t>{2}, 0).nodes[2].radius, 0);
}

TEST(Edits, two_negatives_do_not_press_into_each_other) {
    Document document = starting_document();
    append_node(document, {.id = -1, .parent = 0, .position = Vec3(0, 0, 1), .radius = 0.2});
    document = set_type(document, std::vector<std::int32_t>{0, 1}, NodeType::negative);
    EXPECT_TRUE(validate(document)) << validate(document).error().text();
    EXPECT_EQ(document.nodes[0].type, NodeType::sphere);
    EXPECT_EQ(document.nodes[1].type, NodeType::negative);
}

}  // namespace
}  // namespace sinew::modeler
