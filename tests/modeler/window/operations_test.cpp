// The larger operations by their keys, and the panel that adjusts them.

#include <gmock/gmock.h>

#include <QDoubleSpinBox>
#include <QFrame>

#include "document/delta.h"
#include "document/edits.h"
#include "robot.h"

namespace sinew::modeler {
namespace {

/// A trunk with two arms, without symmetry.
void draw_a_fork(Robot& robot) {
    robot.look_from_front();
    robot.drag({0, 0, 0}, {0, 0, 2}, Qt::ControlModifier);
    robot.drag({0, 0, 2}, {2, 0, 3}, Qt::ControlModifier);
    ASSERT_EQ(robot.document().nodes.size(), 3u);
}

QFrame& panel(Robot& robot) { return *robot.window().findChild<QFrame*>("adjust_panel"); }

TEST(Operations, leaves_are_consolidated_and_the_step_adjusted) {
    Robot robot;
    draw_a_fork(robot);
    const int steps = robot.window().model().history().count();
    robot.key(Qt::Key_C, Qt::ShiftModifier);
    ASSERT_EQ(robot.document().nodes.size(), 4u);
    ASSERT_TRUE(panel(robot).isVisible());
    const Document first = robot.document();
    robot.screenshot("20-consolidated");
    auto* distance = panel(robot).findChild<QDoubleSpinBox*>("adjust_distance");
    distance->setFocus();
    distance->selectAll();
    robot.type("0.5");
    robot.key(Qt::Key_Return);
    EXPECT_FALSE(same(robot.document(), first));
    EXPECT_EQ(robot.document().nodes.size(), 4u);
    EXPECT_EQ(robot.window().model().history().count(), steps + 1);
    panel(robot).parentWidget()->setFocus();
    robot.key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(robot.document().nodes.size(), 3u);
    EXPECT_FALSE(panel(robot).isVisible());
}

TEST(Operations, two_of_a_kind_are_two_steps) {
    Robot robot;
    draw_a_fork(robot);
    const int steps = robot.window().model().history().count();
    robot.key(Qt::Key_C, Qt::ShiftModifier);
    robot.key(Qt::Key_C, Qt::ShiftModifier);
    EXPECT_EQ(robot.window().model().history().count(), steps + 2);
}

TEST(Operations, the_active_node_becomes_the_root) {
    Robot robot;
    draw_a_fork(robot);
    robot.key(Qt::Key_R);
    EXPECT_EQ(robot.document().nodes[2].parent, -1);
    EXPECT_EQ(robot.document().nodes[0].parent, 1);
    EXPECT_FALSE(robot.window().findChild<QFrame*>("adjust_panel")->isVisible());
}

TEST(Operations, the_mirror_image_becomes_nodes) {
    Robot robot;
    draw_a_fork(robot);
    robot.key(Qt::Key_M, Qt::ControlModifier);
    EXPECT_EQ(robot.document().symmetry.kind, Symmetry::Kind::none);
    EXPECT_EQ(robot.document().nodes.size(), 4u);
    // The two tips, one on either side, become one in the middle.
    robot.click({2, 0, 3});
    robot.click({-2, 0, 3}, Qt::ShiftModifier);
    robot.key(Qt::Key_M);
    ASSERT_EQ(robot.document().nodes.size(), 3u);
    EXPECT_NEAR(robot.document().nodes[2].position.x(), 0, 1e-9);
}

}  // namespace
}  // namespace sinew::modeler
