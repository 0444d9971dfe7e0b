// The first model of docs/modeler.md, step by step as the page tells it; its pictures are made here.
// tools/modeler-docs copies them.

#include <gmock/gmock.h>

#include <QTest>

#include "robot.h"
#include "viewport/viewport.h"

namespace sinew::modeler {
namespace {

TEST(Guide, a_first_model) {
    Robot robot;
    Viewport& viewport = robot.window().viewport();
    robot.window().resize(1120, 700);
    ASSERT_TRUE(Robot::wait([&] { return robot.window().width() == 1120; }));
    robot.key(Qt::Key_Home);
    ASSERT_TRUE(robot.wait_for_mesh());
    robot.screenshot("guide-1-start");

    // 1: a spine, from the root upwards.
    robot.look_from_front();
    robot.drag({0, 0, 0}, {0, 0, 2}, Qt::ControlModifier);
    ASSERT_EQ(robot.document().nodes.size(), 2u);
    ASSERT_TRUE(robot.wait_for_mesh());
    robot.screenshot("guide-2-spine");

    // 2: an arm; the other one comes with it. The picture is taken before the button is let go.
    const QPoint chest = robot.pixel({0, 0, 2}), elbow = robot.pixel({1.5, 0, 1.5});
    QTest::mouseMove(&viewport, chest);
    QTest::mousePress(&viewport, Qt::LeftButton, {}, chest);
    for (int i = 1; i <= 4; ++i) QTest::mouseMove(&viewport, chest + (elbow - chest) * i / 4);
    ASSERT_TRUE(robot.wait_for_mesh());
    robot.screenshot("guide-3-arms");
    QTest::mouseRelease(&viewport, Qt::LeftButton, Qt::ControlModifier, elbow);
    ASSERT_EQ(robot.document().nodes.size(), 3u);
    robot.key(Qt::Key_S);
    robot.type("0.5");
    robot.key(Qt::Key_Return);
    EXPECT_NEAR(robot.document().nodes[2].radius, 0.25, 1e-9);
    robot.drag({1.5, 0, 1.5}, {2.5, 0, 2.5}, Qt::ControlModifier);

    // 3: legs and feet, and a head: a ball.
    robot.drag({0, 0, 0}, {1, 0, -2}, Qt::ControlModifier);
    robot.key(Qt::Key_S);
    robot.type("0.6");
    robot.key(Qt::Key_Return);
    robot.drag({1, 0, -2}, {1.5, 0, -3}, Qt::ControlModifier);
    robot.key(Qt::Key_T);
    robot.screenshot("guide-4-types");
    robot.key(Qt::Key_4);
    ASSERT_EQ(robot.document().nodes.back().type, NodeType::cube);
    robot.drag({0, 0, 2}, {0, 0, 3.5}, Qt::ControlModifier);
    robot.key(Qt::Key_S);
    robot.type("1.6");
    robot.key(Qt::Key_Return);
    robot.key(Qt::Key_6, Qt::ControlModifier);
    ASSERT_EQ(robot.document().nodes.size(), 7u);
    ASSERT_TRUE(robot.wait_for_mesh());
    EXPECT_TRUE(robot.window().meshes().mesh()->validation->solid());

    // 4: look at it from elsewhere, smoother, through it.
    robot.key(Qt::Key_5, Qt::KeypadModifier);
    const QPoint middle = viewport.rect().center();
    QTest::mousePress(&viewport, Qt::MiddleButton, {}, middle);
    QTest::mouseMove(&viewport, middle + QPoint(-70, 25));
    QTest::mouseRelease(&viewport, Qt::MiddleButton, {}, middle + QPoint(-70, 25));
    robot.key(Qt::Key_Home);
    robot.key(Qt::Key_2);
    ASSERT_TRUE(robot.wait_for_mesh());
    robot.screenshot("guide-5-figure");
    robot.key(Qt::Key_X, Qt::AltModifier);
    robot.key(Qt::Key_I, Qt::AltModifier);
    robot.screenshot("guide-6-see-through");
}

}  // namespace
}  // namespace sinew::modeler
