#include "document/model.h"

#include <gtest/gtest.h>

#include "document/delta.h"
#include "document/edits.h"
#include "stage.h"

namespace sinew::modeler {
namespace {

Document wider(const Model& model, double factor) {
    return scale_radii(model.document(), std::vector<std::int32_t>{0}, factor);
}

TEST(Model, undo_and_redo_lead_through_every_state) {
    Model model;
    model.replace(plain_document(), true);
    std::vector<Document> states{model.document()};
    for (int i = 0; i < 5; ++i) {
        Edited edit = add_children(model.document(), std::vector<std::int32_t>{i});
        model.apply("Extrude", std::move(edit.document), std::move(edit.selection));
        states.push_back(model.document());
    }
    EXPECT_EQ(model.selection().active, 5);
    for (int i = 4; i >= 0; --i) {
        model.undo();
        EXPECT_TRUE(same(model.document(), states[i]));
    }
    EXPECT_FALSE(model.history().canUndo());
    EXPECT_FALSE(model.modified());
    for (int i = 1; i <= 5; ++i) {
        model.redo();
        EXPECT_TRUE(same(model.document(), states[i]));
    }
    EXPECT_EQ(model.selection().active, 5);
    EXPECT_EQ(model.history().undoText(), "Extrude");
}

TEST(Model, a_new_edit_clears_redo) {
    Model model;
    model.replace(plain_document(), true);
    model.apply("Radius", wider(model, 2));
    model.undo();
    model.apply("Radius", wider(model, 3));
    EXPECT_FALSE(model.history().canRedo());
    EXPECT_EQ(model.document().nodes[0].radius, 1.5);
}

TEST(Model, a_drag_is_one_step) {
    Model model;
    model.replace(plain_document(), true);
    for (double factor : {1.1, 1.2, 1.3}) model.preview(wider(model, factor), {});
    EXPECT_TRUE(model.previewing());
    model.commit("Radius");
    EXPECT_EQ(model.history().count(), 1);
    model.undo();
    EXPECT_TRUE(same(model.document(), plain_document()));
}

TEST(Model, a_cancelled_drag_leaves_nothing) {
    Model model;
    model.replace(plain_document(), true);
    model.select(selection_of(0));
    model.preview(wider(model, 2), {});
    model.cancel();
    EXPECT_TRUE(same(model.document(), plain_document()));
    EXPECT_EQ(model.selection(), selection_of(0));
    EXPECT_EQ(model.history().count(), 0);
    model.preview(wider(model, 2), {});
    model.undo();  // takes the drag back, not the step before it
    EXPECT_FALSE(model.previewing());
    EXPECT_EQ(model.document().nodes[0].radius, 0.5);
}

TEST(Model, what_changes_nothing_is_no_step) {
    Model model;
    model.replace(plain_document(), true);
    model.apply("Nothing", model.document(), selection_of(0));
    model.preview(model.document(), {});
    model.commit("Nothing");
    EXPECT_EQ(model.history().count(), 0);
    EXPECT_FALSE(model.modified());
}

TEST(Model, edits_with_a_key_merge_until_something_else_happens) {
    Model model;
    model.replace(plain_document(), true);
    for (int i = 0; i < 4; ++i) model.apply("Radius", wider(model, 2), {}, 7);
    EXPECT_EQ(model.history().count(), 1);
    EXPECT_EQ(model.document().nodes[0].radius, 8);
    model.select(selection_of(0));
    model.apply("Radius", wider(model, 2), selection_of(0), 7);
    EXPECT_EQ(model.history().count(), 2);
    model.undo();
    EXPECT_EQ(model.document().nodes[0].radius, 8);
    model.undo();
    EXPECT_EQ(model.document().nodes[0].radius, 0.5);
    model.redo();
    EXPECT_EQ(model.document().nodes[0].radius, 8);
}

TEST(Model, saved_is_a_place_in_the_history) {
    Model model;
    model.replace(plain_document(), false);
    EXPECT_TRUE(model.modified());
    model.mark_saved();
    model.apply("Radius", wider(model, 2));
    EXPECT_TRUE(model.modified());
    model.undo();
    EXPECT_FALSE(model.modified());
}

TEST(Model, observers_hear_what_changed) {
    Model model;
    int documents = 0, selections = 0, replaced = 0;
    model.observe([&](const Changes& changes) {
        documents += changes.document;
        selections += changes.selection;
        replaced += changes.replaced;
    });
    model.replace(plain_document(), true);
    model.select(selection_of(0));
    model.select(selection_of(0));
    model.apply("Radius", wider(model, 2));
    model.undo();
    EXPECT_EQ(documents, 3);
    EXPECT_EQ(selections, 2);
    EXPECT_EQ(replaced, 1);
}

}  // namespace
}  // namespace sinew::modeler
