#include "window/status_line.h"

#include <gmock/gmock.h>

#include <QLabel>
#include <QMenu>
#include <QStatusBar>
#include <QTest>
#include <QToolButton>

#include "desk_window.h"
#include "modeler/stage.h"
#include "window/mesh_keeper.h"

namespace sinew::modeler {
namespace {

using testing::HasSubstr;

TEST(DescribePointer, says_what_a_drag_will_do) {
    Hand hand(plain_document());
    hand.drag({0, 0}, {3, 0});
    const auto at = [&](double x, double z) {
        hand.tools.move(Hand::at(x, z), hand.screen);
        return describe_pointer(hand.tools);
    };
    EXPECT_THAT(at(0, 0), HasSubstr("child"));
    EXPECT_THAT(at(1.5, 0), HasSubstr("insert a node"));
    EXPECT_THAT(at(0, 2.5), HasSubstr("box"));
    hand.tools.tool = Tool::move;
    hand.model.select({});
    EXPECT_THAT(at(0, 0), HasSubstr("Drag to move"));
    hand.tools.tool = Tool::radius;
    EXPECT_THAT(at(0, 0), HasSubstr("radius"));
}

TEST(DescribePointer, says_what_keys_do_while_a_gesture_runs) {
    for (const auto& [modal, said] : {std::pair{Modal::move, "hold an axis"},
                                      {Modal::extrude, "Ctrl snaps"},
                                      {Modal::radius, "factor"},
                                      {Modal::link, "Click a node"}}) {
        Hand hand(plain_document());
        hand.model.select(selection_of(0));
        ASSERT_TRUE(hand.tools.start(modal, Hand::at(0, 0), hand.screen));
        EXPECT_THAT(describe_pointer(hand.tools), HasSubstr(said));
        EXPECT_THAT(describe_pointer(hand.tools), HasSubstr("Esc"));
    }
}

TEST(StatusLine, shows_selection_symmetry_and_mesh) {
    DeskWindow desk;
    StatusLine line(*desk.window.statusBar(), desk.actions);
    MeshKeeper meshes(desk.desk.model, desk.desk.view, [](const auto&) {});
    const auto text = [&](const char* name) {
        line.show(desk.desk.model, desk.desk.tools, desk.desk.view, meshes);
        return desk.window.statusBar()->findChild<QLabel*>(name)->text().toStdString();
    };
    EXPECT_EQ(text("selected"), "");
    desk.desk.model.select(selection_of(std::vector<std::int32_t>{1, 2}));
    EXPECT_EQ(text("selected"), "2 of 5 selected");
    EXPECT_EQ(text("mesh_state"), "skinning...");
    desk.desk.view.live = false;
    EXPECT_EQ(text("mesh_state"), "mesh off");
    auto* symmetry = desk.window.statusBar()->findChild<QToolButton*>("symmetry");
    EXPECT_EQ(symmetry->text(), "no symmetry");
    desk.actions.find("symmetry.y")->trigger();
    text("selected");
    EXPECT_EQ(symmetry->text(), "mirror y");
    EXPECT_TRUE(symmetry->menu()->actions().contains(desk.actions.find("symmetry.x")));
}

TEST(StatusLine, says_skinning_until_the_level_that_was_chosen_is_there) {
    DeskWindow desk;
    StatusLine line(*desk.window.statusBar(), desk.actions);
    MeshKeeper meshes(desk.desk.model, desk.desk.view, [](const auto&) {});
    const auto state = [&] {
        line.show(desk.desk.model, desk.desk.tools, desk.desk.view, meshes);
        return desk.window.statusBar()->findChild<QLabel*>("mesh_state")->text();
    };
    for (const int level : {1, 2}) {
        desk.desk.view.level = level;
        EXPECT_EQ(state(), "skinning...");
        meshes.refresh();
        EXPECT_EQ(state(), "skinning...");  // ordered, not made
        EXPECT_TRUE(QTest::qWaitFor([&] { return state() == QString("level %1").arg(level); }, 60000));
    }
}

TEST(StatusLine, does_not_make_the_window_wider) {
    DeskWindow desk;
    const StatusLine line(*desk.window.statusBar(), desk.actions);
    auto* hint = desk.window.statusBar()->findChild<QLabel*>("hint");
    hint->setText(QString(400, 'w'));
    EXPECT_LT(desk.window.statusBar()->minimumSizeHint().width(), 600);
}

}  // namespace
}  // namespace sinew::modeler
