// From an empty window to a model, by mouse and keys.

#include <gmock/gmock.h>

#include <QLabel>

#include "document/delta.h"
#include "document/edits.h"
#include "robot.h"
#include "sinew/io/skeleton_formats.h"
#include "sinew/skeleton/validate.h"

namespace sinew::modeler {
namespace {

/// What was drawn, without ids: place, radius, type and parent of every node.
void expect_drawn(const Document& drawn, const std::vector<Node>& expected) {
    ASSERT_EQ(drawn.nodes.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_LT((drawn.nodes[i].position - expected[i].position).norm(), 1e-9)
            << i << ": " << drawn.nodes[i].position.transpose();
        EXPECT_NEAR(drawn.nodes[i].radius, expected[i].radius, 1e-9) << i;
        EXPECT_EQ(drawn.nodes[i].type, expected[i].type) << i;
        EXPECT_EQ(drawn.nodes[i].parent, expected[i].parent) << i;
    }
}

void expect_solid(Robot& robot) {
    ASSERT_TRUE(robot.wait_for_mesh());
    const auto& mesh = robot.window().meshes().mesh();
    ASSERT_FALSE(mesh->error) << mesh->error->text();
    EXPECT_TRUE(mesh->validation->solid());
    EXPECT_EQ(mesh->validation->euler, 2 * mesh->components - 2 * mesh->cycles);
}

void expect_undo_and_redo_of_all(Robot& robot) {
    const Document done = robot.document();
    const int steps = robot.window().model().history().count();
    for (int i = 0; i < steps; ++i) robot.key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(same(robot.document(), starting_document()));
    for (int i = 0; i < steps; ++i) robot.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_TRUE(same(robot.document(), done));
}

TEST(Window, starts_with_a_red_root_and_a_mirror) {
    Robot robot;
    EXPECT_TRUE(same(robot.document(), starting_document()));
    expect_solid(robot);
    EXPECT_EQ(robot.window().windowTitle(), "Untitled[*] - Skeleton Modeler");
    robot.screenshot("01-start");
}

TEST(Window, a_tube_is_one_drag) {
    Robot robot;
    robot.look_from_front();
    robot.drag({0, 0, 0}, {0, 0, 3}, Qt::ControlModifier);
    expect_drawn(robot.document(),
                 {{.radius = 0.5}, {.parent = 0, .position = Vec3(0, 0, 3), .radius = 0.5}});
    EXPECT_EQ(robot.window().model().history().count(), 1);
    expect_solid(robot);
    EXPECT_EQ(robot.window().meshes().mesh()->components, 1);
    robot.screenshot("02-tube");
    expect_undo_and_redo_of_all(robot);
}

TEST(Window, a_lollipop) {
    Robot robot;
    robot.look_from_front();
    // A thin stick: the radius by figures. Then up, and a large ball at its end.
    robot.key(Qt::Key_S);
    robot.type("0.3");
    robot.key(Qt::Key_Return);
    robot.key(Qt::Key_E);
    robot.move({0.5, 0, 1});
    robot.type("z3");
    robot.key(Qt::Key_Return);
    robot.key(Qt::Key_S);
    robot.type("8");
    robot.key(Qt::Key_Return);
    robot.key(Qt::Key_6, Qt::ControlModifier);
    robot.key(Qt::Key_Home);
    expect_drawn(
        robot.document(),
        {{.radius = 0.15}, {.parent = 0, .position = Vec3(0, 0, 3), .radius = 1.2, .type = NodeType::ball}});
    EXPECT_TRUE(validate(robot.document()));
    ASSERT_TRUE(robot.wait_for_mesh());
    robot.screenshot("03-lollipop");
    expect_undo_and_redo_of_all(robot);
}

TEST(Window, a_ladder_with_a_mirror_and_links) {
    Robot robot;
    robot.look_from_front();
    robot.key(Qt::Key_S);
    robot.type("0.4");
    robot.key(Qt::Key_Return);
    // One rung from the middle, the rail up from its end; two more rungs, each from the rail to the mirror's
    // plane.
    robot.drag({0, 0, 0}, {1, 0, 0}, Qt::ControlModifier);
    robot.drag({1, 0, 0}, {1, 0, 2}, Qt::ControlModifier);
    robot.drag({1, 0, 2}, {1, 0, 4}, Qt::ControlModifier);
    robot.drag({1, 0, 2}, {0, 0, 2}, Qt::ControlModifier);
    robot.drag({1, 0, 4}, {0, 0, 4}, Qt::ControlModifier);
    std::vector<Node> expected{{.radius = 0.2}};
    expected.push_back({.parent = 0, .position = Vec3(1, 0, 0), .radius = 0.2});
    expected.push_back({.parent = 1, .position = Vec3(1, 0, 2), .radius = 0.2});
    expected.push_back({.parent = 2, .position = Vec3(1, 0, 4), .radius = 0.2});
    expected.push_back({.parent = 2, .position = Vec3(0, 0, 2), .radius = 0.2});
    expected.push_back({.parent = 3, .position = Vec3(0, 0, 4), .radius = 0.2});
    expect_drawn(robot.document(), expected);
    expect_solid(robot);
    EXPECT_EQ(robot.window().meshes().mesh()->cycles, 2);
    robot.screenshot("04-ladder");
    // A strut down the middle: a link from rung to rung, which closes two more cycles.
    robot.click({0, 0, 2});
    robot.key(Qt::Key_L);
    robot.move({0, 0, 4});
    robot.screenshot("05-linking");
    robot.click({0, 0, 4});
    ASSERT_EQ(robot.document().links.size(), 1u);
    expect_solid(robot);
    EXPECT_EQ(robot.window().meshes().mesh()->cycles, 3);
    expect_undo_and_redo_of_all(robot);
}

TEST(Window, what_is_drawn_on_the_image_goes_to_the_drawn_side) {
    Robot robot;
    robot.look_from_front();
    robot.drag({0, 0, 0}, {2, 0, 1}, Qt::ControlModifier);
    robot.drag({-2, 0, 1}, {-3, 0, 2}, Qt::ControlModifier);
    expect_drawn(robot.document(), {{.radius = 0.5},
                                    {.parent = 0, .position = Vec3(2, 0, 1), .radius = 0.5},
                                    {.parent = 1, .position = Vec3(3, 0, 2), .radius = 0.5}});
    expect_solid(robot);
}

}  // namespace
}  // namespace sinew::modeler
