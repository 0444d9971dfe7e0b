// States that are easily forgotten: small windows, long names, nothing at all. Their pictures are to be
// looked at; what can be said in figures is tested.

#include <gmock/gmock.h>

#include <QAction>
#include <QFile>
#include <QLabel>
#include <QTest>
#include <QToolBar>
#include <QToolButton>

#include "document/edits.h"
#include "robot.h"
#include "sinew/io/skeleton_formats.h"
#include "viewport/viewport.h"
#include "window/action_set.h"

namespace sinew::modeler {
namespace {

void resize(Robot& robot, int width, int height) {
    robot.window().resize(width, height);
    ASSERT_TRUE(Robot::wait([&] { return robot.window().size() == QSize(width, height); }))
        << robot.window().width() << " x " << robot.window().height();
}

TEST(Looks, a_small_window_has_room_for_all_tools) {
    Robot robot;
    resize(robot, 1024, 640);
    robot.look_from_front();
    robot.drag({0, 0, 0}, {0, 0, 2}, Qt::ControlModifier);
    ASSERT_TRUE(robot.wait_for_mesh());
    robot.screenshot("60-small");
    auto* bar = robot.window().findChild<QToolBar*>("toolbar");
    for (QAction* action : bar->actions())
        EXPECT_TRUE(bar->widgetForAction(action)->isVisible()) << action->objectName().toStdString();
    EXPECT_GT(robot.window().viewport().width(), 400);
}

TEST(Looks, the_digits_of_the_bar_are_all_levels_there_are) {
    Robot robot;
    for (int level = 0; level <= most_levels; ++level) {
        QAction* action = robot.window().actions().find("view.level" + std::to_string(level));
        ASSERT_TRUE(action);
        EXPECT_EQ(action->shortcut(), QKeySequence(QString::number(level)));
        auto* bar = robot.window().findChild<QToolBar*>("toolbar");
        QTest::mouseClick(bar->widgetForAction(action), Qt::LeftButton);
        EXPECT_EQ(robot.window().view().level, level);
    }
    EXPECT_FALSE(find_action("view.level" + std::to_string(most_levels + 1)));
    robot.key(Qt::Key_1);
    ASSERT_TRUE(robot.wait_for_mesh());
}

TEST(Looks, long_names_are_cut_and_widen_nothing) {
    const TemporaryFolder folder;
    const QString name =
        QString("a very long name that somebody has given to a skeleton ").repeated(3) + ".sinew";
    const QString path = QString::fromStdString(folder.file(name.toStdString()));
    Document document = starting_document();
    append_node(document, {.id = -1, .parent = 0, .position = Vec3(0, 0, 2), .radius = 0.4});
    document = rename(document, 1, "the left forearm of the third goat from the left");
    ASSERT_TRUE(write_skeleton(document, path.toStdString()));
    Robot robot(path);
    resize(robot, 1024, 640);
    robot.key(Qt::Key_A, Qt::ControlModifier);
    robot.key(Qt::Key_N, Qt::AltModifier);
    ASSERT_TRUE(robot.wait_for_mesh());
    EXPECT_EQ(robot.window().files().name(), name);
    robot.screenshot("61-long-names");
    EXPECT_EQ(robot.window().size(), QSize(1024, 640));
    robot.click({0, 0, 2});
    robot.screenshot("62-long-name-of-a-node");
    EXPECT_EQ(robot.window().size(), QSize(1024, 640));
}

TEST(Looks, of_nothing) {
    Robot robot;
    robot.key(Qt::Key_A, Qt::ControlModifier);
    robot.key(Qt::Key_X);
    ASSERT_TRUE(robot.document().nodes.empty());
    robot.screenshot("63-empty");
    // A click is enough to begin again.
    const QPoint middle = robot.window().viewport().rect().center();
    QTest::mouseClick(&robot.window().viewport(), Qt::LeftButton, {}, middle);
    EXPECT_EQ(robot.document().nodes.size(), 1u);
}

TEST(Looks, of_a_gesture_say_what_its_keys_do) {
    Robot robot;
    robot.look_from_front();
    robot.drag({0, 0, 0}, {0, 0, 2}, Qt::ControlModifier);
    robot.key(Qt::Key_E);
    robot.move({1.5, 0, 2.7});
    robot.type("x1.5");
    ASSERT_TRUE(robot.wait_for_mesh());
    robot.screenshot("64-extruding");
    EXPECT_THAT(robot.window().findChild<QLabel*>("hint")->text().toStdString(),
                testing::HasSubstr("Esc takes it back"));
    robot.key(Qt::Key_Return);
    EXPECT_NEAR(robot.document().nodes[2].position.x(), 1.5, 1e-9);
}

}  // namespace
}  // namespace sinew::modeler
