// Grow from L-system: live in the viewport, one step or none.

#include <gmock/gmock.h>

#include <QAction>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>

#include "document/delta.h"
#include "document/edits.h"
#include "robot.h"
#include "window/action_set.h"

namespace sinew::modeler {
namespace {

const QString tree = QString(SINEW_LSYSTEMS) + "/honda_a.lsys";

/// Where all of it is, on average.
Vec3 middle_of(const Document& document) {
    Vec3 sum = Vec3::Zero();
    for (const Node& node : document.nodes) sum += node.position;
    return sum / static_cast<double>(document.nodes.size());
}

QDockWidget& open(Robot& robot, const QString& path) {
    robot.when_asked_for_file("grow_file", path);
    robot.key(Qt::Key_G, Qt::ControlModifier);
    auto* panel = robot.window().findChild<QDockWidget*>("grow_panel");
    EXPECT_TRUE(panel);
    return *panel;
}

void set(QDockWidget& panel, const char* name, const QString& value) {
    auto* box = panel.findChild<QAbstractSpinBox*>(name);
    ASSERT_TRUE(box) << name;
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, value);
    QTest::keyClick(box, Qt::Key_Return);
}

void press(QDockWidget& panel, QDialogButtonBox::StandardButton button) {
    QTest::mouseClick(panel.findChild<QDialogButtonBox*>()->button(button), Qt::LeftButton);
}

TEST(Growing, changes_live_and_is_one_step) {
    Robot robot;
    QDockWidget& panel = open(robot, tree);
    // Two beforees leave each node but the first: a node more than 1 + 2 + 4 + ...
    ASSERT_TRUE(Robot::wait([&] { return robot.document().nodes.size() == 1024; }));
    EXPECT_EQ(robot.window().model().history().count(), 0);
    const Vec3 before = middle_of(robot.document());
    set(panel, "grow_a0", "25");
    ASSERT_TRUE(Robot::wait([&] { return middle_of(robot.document()) != before; }));
    ASSERT_TRUE(robot.wait_for_mesh());
    robot.screenshot("30-growing");
    set(panel, "grow_steps", "7");
    ASSERT_TRUE(Robot::wait([&] { return robot.document().nodes.size() == 128; }));
    const Document last = robot.document();
    // It covers nothing but the properties.
    EXPECT_TRUE(robot.window().findChild<QWidget*>("statistics")->isVisible());
    const auto* properties = robot.window().findChild<QWidget*>("properties_title");
    EXPECT_TRUE(properties->visibleRegion().isEmpty());
    press(panel, QDialogButtonBox::Ok);
    EXPECT_TRUE(Robot::wait([&] { return !properties->visibleRegion().isEmpty(); }));
    EXPECT_TRUE(same(robot.document(), last));
    EXPECT_EQ(robot.window().model().history().count(), 1);
    robot.key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(same(robot.document(), starting_document()));
}

TEST(Growing, cancel_leaves_all_as_it_was) {
    Robot robot;
    QDockWidget& panel = open(robot, tree);
    ASSERT_TRUE(Robot::wait([&] { return robot.document().nodes.size() > 1; }));
    EXPECT_FALSE(robot.window().actions().find("node.extrude")->isEnabled());
    EXPECT_TRUE(robot.window().actions().find("view.wire")->isEnabled());
    press(panel, QDialogButtonBox::Cancel);
    EXPECT_TRUE(same(robot.document(), starting_document()));
    EXPECT_EQ(robot.window().model().history().count(), 0);
    robot.window().model().select(selection_of(0));
    robot.window().actions().refresh();
    EXPECT_TRUE(robot.window().actions().find("node.extrude")->isEnabled());
}

TEST(Growing, too_much_is_refused_with_its_count) {
    Robot robot;
    QDockWidget& panel = open(robot, tree);
    ASSERT_TRUE(Robot::wait([&] { return robot.document().nodes.size() > 1; }));
    set(panel, "grow_steps", "30");
    auto* state = panel.findChild<QLabel*>("grow_state");
    ASSERT_TRUE(Robot::wait([&] { return state->text().contains("1073741824"); }))
        << state->text().toStdString();
    EXPECT_FALSE(panel.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled());
    robot.screenshot("32-grow-refused");
    press(panel, QDialogButtonBox::Cancel);
}

}  // namespace
}  // namespace sinew::modeler
