#include "tools/interaction.h"

#include <gmock/gmock.h>

#include "document/delta.h"
#include "sinew/skeleton/validate.h"
#include "stage.h"
#include "tools/gizmo.h"

namespace sinew::modeler {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

void expect_near(const Vec3& a, const Vec3& b, double within = 1e-9) {
    EXPECT_LT((a - b).norm(), within) << a.transpose();
}

TEST(Drawing, a_straight_tube_is_one_drag) {
    Hand hand(starting_document());
    hand.drag({0.1, 0}, {0.12, 3});
    ASSERT_EQ(hand.model.document().nodes.size(), 2u);
    EXPECT_EQ(hand.node(1).position.x(), 0);  // it sticks to the mirror's plane, exactly
    expect_near(hand.node(1).position, {0, 0, 3});
    EXPECT_EQ(hand.node(1).radius, hand.node(0).radius);
    EXPECT_EQ(hand.model.history().count(), 1);
    EXPECT_EQ(hand.model.history().undoText(), "Extrude");
    EXPECT_EQ(hand.model.selection().active, 1);
}

TEST(Drawing, a_limb_drawn_on_the_image_goes_to_the_drawn_side) {
    Hand hand(starting_document());
    hand.drag({0, 0}, {2, 1});
    hand.drag({-2, 1}, {-3, 2});
    ASSERT_EQ(hand.model.document().nodes.size(), 3u);
    expect_near(hand.node(2).position, {3, 0, 2});
    EXPECT_EQ(hand.node(2).parent, 1);
}

TEST(Drawing, from_a_bone_a_node_is_inserted) {
    Hand hand(plain_document());
    hand.drag({0, 0}, {4, 0});
    hand.drag({2, 0}, {2, 1});
    ASSERT_EQ(hand.model.document().nodes.size(), 3u);
    expect_near(hand.node(2).position, {2, 0, 1});
    EXPECT_EQ(hand.node(2).parent, 0);
    EXPECT_EQ(hand.node(1).parent, 2);
}

TEST(Drawing, in_perspective_the_node_follows_the_pointer) {
    Hand hand(plain_document());
    hand.screen = perspective_screen();
    hand.drag({0, 0}, {2.5, 1});
    const Vec2 shown = *hand.screen.project(hand.node(1).position);
    EXPECT_LT((shown - pixel_of(2.5, 1)).norm(), 1e-6);
}

TEST(Drawing, in_nothing_a_click_makes_a_root) {
    Hand hand{Document{}};
    hand.click(1, 2);
    ASSERT_EQ(hand.model.document().nodes.size(), 1u);
    expect_near(hand.node(0).position, {1, 0, 2});
}

TEST(Moving, takes_the_selection_along) {
    Hand hand(plain_document());
    hand.drag({0, 0}, {2, 0});
    hand.drag({2, 0}, {4, 0});
    hand.tools.tool = Tool::move;
    hand.click(2, 0);
    hand.click(4, 0, true);
    EXPECT_THAT(hand.model.selection().nodes, ElementsAre(1, 2));
    hand.drag({3.9, 0.2}, {3.9, 1.2});
    expect_near(hand.node(1).position, {2, 0, 1});
    expect_near(hand.node(2).position, {4, 0, 1});
    expect_near(hand.node(0).position, {0, 0, 0});
    hand.drag({0.2, 0.1}, {0.2, -0.9});  // not selected: alone
    expect_near(hand.node(0).position, {0, 0, -1});
    EXPECT_THAT(hand.model.selection().nodes, ElementsAre(0));
}

TEST(Moving, keys_hold_an_axis_or_a_plane) {
    Hand hand(plain_document());
    hand.click(0, 0);
    ASSERT_TRUE(hand.tools.start(Modal::move, Hand::at(0, 0), hand.screen));
    hand.tools.move(Hand::at(2, 1), hand.screen);
    EXPECT_TRUE(hand.tools.type('x', hand.screen));
    expect_near(hand.node(0).position, {2, 0, 0});
    EXPECT_THAT(hand.tools.hint(), HasSubstr("along X"));
    EXPECT_TRUE(hand.tools.type('X', hand.screen));
    expect_near(hand.node(0).position, {0, 0, 1}, 1e-6);
    EXPECT_TRUE(hand.tools.type('X', hand.screen));  // again: free
    expect_near(hand.node(0).position, {2, 0, 1});
    hand.tools.cancel();
    expect_near(hand.node(0).position, {0, 0, 0});
    EXPECT_EQ(hand.model.history().count(), 0);
}

TEST(Moving, figures_are_exact) {
    Hand hand(plain_document());
    hand.click(0, 0);
    hand.tools.start(Modal::extrude, Hand::at(0, 0), hand.screen);
    hand.tools.move(Hand::at(0.4, 0.4), hand.screen);
    for (char key : {'z', '2', '.', '7', '5', '\b', '-'}) EXPECT_TRUE(hand.tools.type(key, hand.screen));
    EXPECT_THAT(hand.tools.hint(), HasSubstr("-2.7"));
    hand.tools.finish();
    EXPECT_EQ(hand.node(1).position, Vec3(0, 0, -2.7));
}

TEST(Moving, ctrl_snaps_to_grid_nodes_and_angles) {
    Hand hand(plain_document());
    hand.drag({0, 0}, {2.07, 1.13}, true);
    expect_near(hand.node(1).position, {2, 0, 1.2});
    hand.drag({0, 0}, {1.95, 1.27}, true);  // near the other node: coincident on purpose
    EXPECT_EQ(hand.node(2).position, hand.node(1).position);
    hand.tools.snap_to = SnapTo::angle;
    hand.drag({0, 0}, {-2, 1.9}, true);
    EXPECT_NEAR(hand.node(3).position.z(), -hand.node(3).position.x(), 1e-9);
    EXPECT_NEAR(hand.node(3).position.norm(), Vec2(2, 1.9).norm(), 1e-9);
}

TEST(Moving, by_the_gizmo_keeps_to_the_arrow) {
    Hand hand(plain_document());
    hand.tools.tool = Tool::move;
    hand.click(0, 0);
    ASSERT_TRUE(hand.tools.gizmo_place());
    const double tip = gizmo_arm / 100 - 0.05;
    hand.drag({0, tip}, {1, tip + 1});
    expect_near(hand.node(0).position, {0, 0, 1});
    const double square = gizmo_square / 100;
    hand.drag({square, 1 + square}, {square + 1, 2 + square});
    expect_near(hand.node(0).position, {1, 0, 2}, 1e-6);
    EXPECT_FALSE(
        gizmo_at(hand.screen, {0, 0, 0}, pixel_of(0, 0)));  // the arrow into the screen cannot be taken
}

TEST(Radius, the_outline_follows_the_pointer) {
    Hand hand(plain_document());
    hand.tools.tool = Tool::radius;
    hand.drag({0.5, 0}, {1.25, 0});
    EXPECT_NEAR(hand.node(0).radius, 1.25, 1e-9);
    hand.tools.tool = Tool::draw;
    hand.tools.press(Hand::at(1, 0, true), hand.screen);  // Ctrl at the press means the radius in every tool
    hand.tools.move(Hand::at(0.5, 0, true), hand.screen);
    hand.tools.release(Hand::at(0.5, 0, true), hand.screen);
    EXPECT_NEAR(hand.node(0).radius, 0.75, 1e-9);
    EXPECT_EQ(hand.model.history().undoText(), "Radius");
}

TEST(Radius, never_reaches_zero) {
    Hand hand(plain_document());
    hand.tools.tool = Tool::radius;
    hand.drag({0.45, 0}, {0, 0});
    EXPECT_GT(hand.node(0).radius, 0);
    EXPECT_TRUE(validate(hand.model.document()));
}

TEST(Radius, the_wheel_over_a_node_is_one_step) {
    Hand hand(plain_document());
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(hand.tools.wheel(Hand::at(0.1, 0), hand.screen, 1));
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(hand.tools.wheel(Hand::at(0.1, 0), hand.screen, -1));
    EXPECT_TRUE(hand.tools.wheel(Hand::at(0.1, 0), hand.screen, 1));
    EXPECT_GT(hand.node(0).radius, 0.5);
    EXPECT_LE(hand.model.history().count(), 1);
    EXPECT_FALSE(hand.tools.wheel(Hand::at(3, 3), hand.screen, 1));
}

TEST(Selecting, clicks_boxes_and_shift) {
    Hand hand(plain_document());
    hand.drag({0, 0}, {3, 0});
    hand.drag({3, 0}, {3, 3});
    hand.click(3, 3);
    EXPECT_THAT(hand.model.selection().nodes, ElementsAre(2));
    hand.click(0, 0, true);
    EXPECT_THAT(hand.model.selection().nodes, ElementsAre(0, 2));
    hand.click(-3, 2);
    EXPECT_TRUE(hand.model.selection().empty());
    hand.drag({-1, -1}, {3.9, 1});
    EXPECT_THAT(hand.model.selection().nodes, ElementsAre(0, 1));
    hand.drag({2, 2}, {3.9, 3.5}, false, true);
    EXPECT_THAT(hand.model.selection().nodes, ElementsAre(0, 1, 2));
    hand.click(1.5, 0);  // a bone: its ends
    EXPECT_THAT(hand.model.selection().nodes, ElementsAre(0, 1));
    EXPECT_EQ(hand.model.history().count(), 2);  // selecting is no edit
}

TEST(Selecting, a_second_click_reaches_what_is_hidden_and_a_drag_takes_it) {
    Document document = plain_document();
    append_node(document, {.id = -1, .parent = 0, .position = Vec3(0, 3, 0), .radius = 0.5});
    Hand hand(document);
    hand.tools.tool = Tool::move;
    hand.click(0.3, 0.3);
    EXPECT_EQ(hand.model.selection().active, 0);
    hand.click(0.3, 0.3);
    EXPECT_EQ(hand.model.selection().active, 1);
    hand.drag({0.3, 0.3}, {2.3, 0.3});
    expect_near(hand.node(1).position, {2, 3, 0});
    expect_near(hand.node(0).position, {0, 0, 0});
}

TEST(Linking, joins_and_parts) {
    Hand hand(plain_document());
    hand.drag({0, 0}, {3, 0});
    hand.drag({3, 0}, {3, 2});
    hand.click(3, 2);
    for (std::size_t expected : {1u, 0u}) {
        ASSERT_TRUE(hand.tools.start(Modal::link, Hand::at(3, 2), hand.screen));
        hand.tools.move(Hand::at(0.1, 0.1), hand.screen);
        EXPECT_TRUE(hand.tools.guides().snapped);
        hand.tools.press(Hand::at(0.1, 0.1), hand.screen);
        hand.tools.release(Hand::at(0.1, 0.1), hand.screen);
        EXPECT_FALSE(hand.tools.active());
        EXPECT_EQ(hand.model.document().links.size(), expected);
        hand.model.select(selection_of(2));
    }
}

TEST(Drawing, everything_can_be_taken_back_and_done_again) {
    Hand hand(starting_document());
    hand.drag({0, 0}, {2, 0});
    hand.drag({2, 0}, {2, 2});
    hand.drag({2, 2}, {0, 2});
    hand.tools.start(Modal::duplicate, Hand::at(0, 2), hand.screen);
    hand.tools.move(Hand::at(0, 4), hand.screen);
    hand.tools.finish();
    const Document done = hand.model.document();
    ASSERT_TRUE(validate(done));
    while (hand.model.history().canUndo()) hand.model.undo();
    EXPECT_TRUE(same(hand.model.document(), starting_document()));
    while (hand.model.history().canRedo()) hand.model.redo();
    EXPECT_TRUE(same(hand.model.document(), done));
}

TEST(Gestures, end_when_something_else_changes_the_document) {
    for (Modal modal : {Modal::move, Modal::radius, Modal::extrude, Modal::duplicate, Modal::link}) {
        Hand hand(plain_document());
        hand.drag({0, 0}, {2, 0});
        hand.click(2, 0);
        ASSERT_TRUE(hand.tools.start(modal, Hand::at(2, 0), hand.screen));
        hand.tools.move(Hand::at(2, 1), hand.screen);
        const Edited edit = erase_nodes(hand.model.document(), selection_of(1));
        hand.model.apply("Delete", edit.document, edit.selection);
        EXPECT_FALSE(hand.tools.active());
        EXPECT_FALSE(hand.tools.hovered());
        hand.tools.move(Hand::at(2, 2), hand.screen);
        EXPECT_FALSE(hand.model.previewing());
        EXPECT_EQ(hand.model.history().undoText(), "Delete");
    }
}

TEST(Hovering, what_lies_under_a_still_pointer_is_found_again) {
    Hand hand(plain_document());
    hand.drag({0, 0}, {2, 0});
    EXPECT_EQ(hand.tools.hovered().index, 1);
    hand.model.undo();
    EXPECT_FALSE(hand.tools.hovered());
    EXPECT_TRUE(hand.tools.look_again(hand.screen));
    EXPECT_FALSE(hand.tools.hovered());
    hand.model.redo();
    EXPECT_TRUE(hand.tools.look_again(hand.screen));
    EXPECT_EQ(hand.tools.hovered().index, 1);
    EXPECT_FALSE(hand.tools.look_again(hand.screen));  // once is enough
}

}  // namespace
}  // namespace sinew::modeler
