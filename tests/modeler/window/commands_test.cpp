// Keys, menus and panels of the real window.

#include <gmock/gmock.h>

#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QTest>
#include <QTimer>
#include <QToolBar>

#include "document/delta.h"
#include "document/edits.h"
#include "panels/outliner.h"
#include "panels/problems.h"
#include "robot.h"
#include "viewport/viewport.h"

namespace sinew::modeler {
namespace {

using testing::ElementsAre;

/// A root, a limb of two bones in the plane of the mirror.
void draw_a_limb(Robot& robot) {
    robot.look_from_front();
    robot.drag({0, 0, 0}, {0, 0, 2}, Qt::ControlModifier);
    robot.drag({0, 0, 2}, {2, 0, 3}, Qt::ControlModifier);
    ASSERT_EQ(robot.document().nodes.size(), 3u);
}

const Selection& selection(Robot& robot) { return robot.window().model().selection(); }

TEST(Commands, selecting_with_mouse_and_keys) {
    Robot robot;
    draw_a_limb(robot);
    robot.click({0, 0, 2});
    EXPECT_THAT(selection(robot).nodes, ElementsAre(1));
    robot.click({2, 0, 3}, Qt::ShiftModifier);
    EXPECT_THAT(selection(robot).nodes, ElementsAre(1, 2));
    robot.key(Qt::Key_I);
    EXPECT_THAT(selection(robot).nodes, ElementsAre(0));
    robot.key(Qt::Key_L, Qt::ControlModifier);
    EXPECT_THAT(selection(robot).nodes, ElementsAre(0, 1, 2));
    robot.key(Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_TRUE(selection(robot).empty());
    robot.drag({-1, 0, 1.4}, {1, 0, 2.6});  // a box round the middle node
    EXPECT_THAT(selection(robot).nodes, ElementsAre(1));
    robot.key(Qt::Key_PageDown);
    EXPECT_THAT(selection(robot).nodes, ElementsAre(2));
    robot.screenshot("40-selected");
}

TEST(Commands, views_and_how_the_mesh_is_shown) {
    Robot robot;
    draw_a_limb(robot);
    Viewport& viewport = robot.window().viewport();
    for (const auto& [key, azimuth, elevation] :
         {std::tuple{Qt::Key_3, 90., 0.}, {Qt::Key_7, 0., 90.}, {Qt::Key_1, 0., 0.}}) {
        robot.key(key, Qt::KeypadModifier);
        EXPECT_EQ(viewport.camera().azimuth, azimuth);
        EXPECT_EQ(viewport.camera().elevation, elevation);
        EXPECT_EQ(viewport.camera().projection, Projection::orthographic);
    }
    robot.key(Qt::Key_5, Qt::KeypadModifier);
    EXPECT_EQ(viewport.camera().projection, Projection::perspective);
    robot.key(Qt::Key_Home);
    for (const auto& [key, level] : {std::pair{Qt::Key_0, 0}, {Qt::Key_3, 3}, {Qt::Key_2, 2}}) {
        robot.key(key);
        EXPECT_EQ(robot.window().view().level, level);
    }
    robot.key(Qt::Key_X, Qt::AltModifier);
    EXPECT_LT(robot.window().view().opacity, 1);
    robot.key(Qt::Key_I, Qt::AltModifier);
    ASSERT_TRUE(robot.wait_for_mesh());
    robot.screenshot("41-see-through");
    robot.key(Qt::Key_X, Qt::AltModifier);
    robot.key(Qt::Key_W);
    robot.key(Qt::Key_2, Qt::AltModifier);
    robot.screenshot("42-matcap");
    robot.key(Qt::Key_3, Qt::AltModifier);
    EXPECT_EQ(robot.window().view().shading, Shading::flat);
    robot.key(Qt::Key_Space);
    EXPECT_FALSE(robot.window().view().live);
    robot.screenshot("43-bones");
}

TEST(Commands, orbit_pan_and_zoom) {
    Robot robot;
    Viewport& viewport = robot.window().viewport();
    const QPoint from(400, 300), to(460, 320);
    const auto drag = [&](Qt::MouseButton button, Qt::KeyboardModifiers held) {
        const Camera before = viewport.camera();
        QTest::mousePress(&viewport, button, held, from);
        QTest::mouseMove(&viewport, to);
        QTest::mouseRelease(&viewport, button, held, to);
        return before;
    };
    for (const auto& [button, held] : {std::pair{Qt::MiddleButton, Qt::KeyboardModifiers()},
                                       {Qt::LeftButton, Qt::KeyboardModifiers(Qt::AltModifier)}}) {
        const Camera before = drag(button, held);
        EXPECT_NE(viewport.camera().azimuth, before.azimuth);
        EXPECT_EQ(viewport.camera().target, before.target);
    }
    const Camera before_pan = drag(Qt::MiddleButton, Qt::ShiftModifier);
    EXPECT_EQ(viewport.camera().azimuth, before_pan.azimuth);
    EXPECT_NE(viewport.camera().target, before_pan.target);
    const Camera before_zoom = drag(Qt::MiddleButton, Qt::ControlModifier);
    EXPECT_NE(viewport.camera().distance, before_zoom.distance);
    EXPECT_TRUE(same(robot.document(), starting_document()));
}

TEST(Commands, any_command_by_a_few_letters) {
    Robot robot;
    robot.key(Qt::Key_K, Qt::ControlModifier);
    robot.type("mirr");
    robot.screenshot("44-palette");
    robot.type("or z");
    robot.key(Qt::Key_Return);
    EXPECT_EQ(robot.document().symmetry.axis, 2);
    EXPECT_EQ(QApplication::focusWidget(), &robot.window().viewport());
}

TEST(Commands, all_keys_on_one_sheet) {
    Robot robot;
    bool seen = false;
    robot.when_dialog("shortcut_sheet", [&](QDialog& dialog) {
        seen = true;
        Robot::screenshot(dialog, "45-keys");
        QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    robot.key(Qt::Key_F1);
    EXPECT_TRUE(seen);
}

TEST(Commands, a_type_from_the_ring_round_the_pointer) {
    Robot robot;
    draw_a_limb(robot);
    robot.move({2, 0, 3});
    robot.key(Qt::Key_T);
    auto* ring = robot.window().findChild<QWidget*>("type_menu");
    ASSERT_TRUE(ring && ring->isVisible());
    QTest::mouseMove(ring, ring->rect().center() + QPoint(80, -40));
    robot.screenshot("46-types");
    robot.key(Qt::Key_4);
    EXPECT_EQ(robot.document().nodes[2].type, NodeType::cube);
    ASSERT_TRUE(robot.wait_for_mesh());
    EXPECT_TRUE(robot.window().meshes().mesh()->validation->solid());
}

TEST(Commands, the_context_menu_is_about_what_is_under_the_pointer) {
    Robot robot;
    draw_a_limb(robot);
    bool seen = false;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&] {
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        if (!menu || menu->objectName() != "context_menu") return;
        timer.stop();
        seen = true;
        Robot::screenshot(*menu, "47-context-menu");
        for (const QAction* action : menu->actions())
            if (action->objectName() == "edit.delete")
                return QTest::mouseClick(menu, Qt::LeftButton, {},
                                         menu->actionGeometry(const_cast<QAction*>(action)).center());
        menu->close();
    });
    timer.start(20);
    QTest::mouseMove(&robot.window().viewport(), robot.pixel({0, 0, 2}));
    QTest::mouseClick(&robot.window().viewport(), Qt::RightButton, {}, robot.pixel({0, 0, 2}));
    EXPECT_TRUE(seen);
    ASSERT_EQ(robot.document().nodes.size(), 2u);
    EXPECT_EQ(robot.document().nodes[1].parent, 0);  // the limb below stays attached
}

TEST(Commands, history_goes_where_one_clicks) {
    Robot robot;
    draw_a_limb(robot);
    const Document done = robot.document();
    auto* steps = robot.window().findChild<QListView*>("history");
    ASSERT_TRUE(steps);
    const auto click = [&](int row) {
        QTest::mouseClick(steps->viewport(), Qt::LeftButton, {},
                          steps->visualRect(steps->model()->index(row, 0)).center());
    };
    ASSERT_EQ(steps->model()->rowCount(), 3);
    click(1);
    EXPECT_EQ(robot.document().nodes.size(), 2u);
    click(0);
    EXPECT_TRUE(same(robot.document(), starting_document()));
    click(2);
    EXPECT_TRUE(same(robot.document(), done));
}

TEST(Commands, problems_are_found_and_selected) {
    Robot robot;
    draw_a_limb(robot);
    // A cone in the middle of a limb is not to be had by keys: it comes with a file.
    const TemporaryFolder folder;
    const QString path = QString::fromStdString(folder.file("odd.sinew"));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(R"({"format": "sinew", "version": 1, "nodes": [
        {"id": 1, "position": [0, 0, 0], "radius": 0.5},
        {"id": 2, "parent": 1, "position": [0, 0, 2], "radius": 0.5, "type": "cone"},
        {"id": 3, "parent": 2, "position": [1, 0, 4], "radius": 0.5}]})");
    file.close();
    robot.window().model().mark_saved();
    robot.open(path);
    ASSERT_EQ(robot.document().nodes.size(), 3u);
    auto* dock = robot.window().findChild<QDockWidget*>("panel_problems");
    EXPECT_EQ(dock->windowTitle(), "Problems (1)");
    dock->raise();
    auto* list = robot.window().findChild<Problems*>("problems");
    ASSERT_TRUE(
        Robot::wait([&] { return list->isVisible() && list->visualItemRect(list->item(0)).isValid(); }));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
    EXPECT_THAT(selection(robot).nodes, ElementsAre(1));
    robot.screenshot("48-problems");
    robot.key(Qt::Key_1, Qt::ControlModifier);  // a sphere: all is well
    ASSERT_TRUE(robot.wait_for_mesh());
    EXPECT_FALSE(robot.window().meshes().mesh()->error);
    EXPECT_EQ(dock->windowTitle(), "Problems");
}

TEST(Commands, a_name_is_given_in_the_outliner) {
    Robot robot;
    draw_a_limb(robot);
    robot.click({2, 0, 3});
    robot.key(Qt::Key_F2);
    robot.type("left hand");
    robot.key(Qt::Key_Return);
    ASSERT_TRUE(Robot::wait([&] { return robot.document().names.size() == 3; }));
    EXPECT_EQ(robot.document().names[2], "left hand");
    EXPECT_EQ(robot.window().model().history().undoText(), "Rename");
}

TEST(Commands, tools_are_taken_from_the_toolbar) {
    Robot robot;
    auto* bar = robot.window().findChild<QToolBar*>("toolbar");
    for (const auto& [id, tool] :
         {std::pair{"tool.move", Tool::move}, {"tool.radius", Tool::radius}, {"tool.draw", Tool::draw}}) {
        QWidget* button = nullptr;
        for (QAction* action : bar->actions())
            if (action->objectName() == id) button = bar->widgetForAction(action);
        ASSERT_TRUE(button) << id;
        QTest::mouseClick(button, Qt::LeftButton);
        EXPECT_EQ(robot.window().tools().tool, tool);
    }
    robot.key(Qt::Key_V);
    robot.look_from_front();
    ASSERT_TRUE(robot.wait_for_mesh());
    robot.screenshot("49-move-tool");
}

TEST(Commands, what_is_chosen_is_remembered) {
    {
        Robot robot;
        robot.key(Qt::Key_2);
        robot.key(Qt::Key_W);
        robot.window().findChild<QDockWidget*>("panel_history")->close();
    }
    Robot robot;
    EXPECT_EQ(robot.window().view().level, 2);
    EXPECT_FALSE(robot.window().view().wire);
    EXPECT_FALSE(robot.window().findChild<QDockWidget*>("panel_history")->isVisible());
}

}  // namespace
}  // namespace sinew::modeler
