// From an empty window to a model, by mouse and keys.

#include <gmock/gmock.h>

#include <QLabel>

#include "document/delta.h"
#include "document/edits.h"
#include "robot.h"
#include "sinew/io/skeleton_formats.h"
#include "sinew/sqm/skin.h"
#include "sinew/subdivide/subdivide.h"

namespace sinew::modeler {
namespace {

/// A document as a file would have it: ids are given in the order of drawing.
Document document_of(std::vector<Node> nodes) {
    Document document;
    document.symmetry = starting_document().symmetry;
    document.unit = starting_document().unit;
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i].id = static_cast<std::int64_t>(i);
    document.nodes = std::move(nodes);
    return document;
}

/// What was drawn: place, radius, type and parent of every node. Pixels are whole: places that are not
/// snapped would be near at best, but all here are.
void expect_drawn(const Document& drawn, const Document& expected) {
    ASSERT_EQ(drawn.nodes.size(), expected.nodes.size());
    for (std::size_t i = 0; i < expected.nodes.size(); ++i) {
        const Node &node = drawn.nodes[i], &wanted = expected.nodes[i];
        EXPECT_LT((node.position - wanted.position).norm(), 1e-9) << i << ": " << node.position.transpose();
        EXPECT_NEAR(node.radius, wanted.radius, 1e-9) << i;
        EXPECT_EQ(node.id, wanted.id) << i;
        EXPECT_EQ(node.type, wanted.type) << i;
        EXPECT_EQ(node.parent, wanted.parent) << i;
    }
    EXPECT_EQ(drawn.links, expected.links);
    EXPECT_EQ(drawn.symmetry, expected.symmetry);
}

/// The mesh that is shown is the one that the library makes of the expected document, as a solid.
void expect_mesh(Robot& robot, const Document& expected) {
    ASSERT_TRUE(robot.wait_for_mesh());
    const auto& shown = robot.window().meshes().mesh();
    ASSERT_FALSE(shown->error) << shown->error->text();
    EXPECT_TRUE(shown->validation->solid());
    EXPECT_EQ(shown->validation->euler, 2 * shown->components - 2 * shown->cycles);
    const auto skinned = skin(expected, {.fit = Fit::limit});
    ASSERT_TRUE(skinned) << skinned.error().text();
    const auto mesh = subdivide(skinned->mesh, {.levels = 1, .limit = true});
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ(shown->mesh->corners, mesh->corners);
    ASSERT_EQ(shown->mesh->positions.size(), mesh->positions.size());
    for (std::size_t i = 0; i < mesh->positions.size(); ++i)
        ASSERT_LT((shown->mesh->positions[i] - mesh->positions[i]).norm(), 1e-5f) << i;
}

/// Saved by keys, read by the library.
void expect_saved(Robot& robot, const Document& expected) {
    const TemporaryFolder folder;
    const std::string path = folder.file("drawn.sinew");
    robot.save_as(QString::fromStdString(path));
    const auto read = read_skeleton(path);
    ASSERT_TRUE(read) << read.error().text();
    expect_drawn(read->document, expected);
    EXPECT_TRUE(same(read->document, robot.document()));
    EXPECT_FALSE(robot.window().isWindowModified());
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
    expect_mesh(robot, starting_document());
    EXPECT_EQ(robot.window().windowTitle(), "Untitled[*] - Skeleton Modeler");
    robot.screenshot("01-start");
}

TEST(Window, a_tube_is_one_drag) {
    Robot robot;
    robot.look_from_front();
    robot.drag({0, 0, 0}, {0, 0, 3}, Qt::ControlModifier);
    const Document expected =
        document_of({{.radius = 0.5}, {.parent = 0, .position = Vec3(0, 0, 3), .radius = 0.5}});
    expect_drawn(robot.document(), expected);
    EXPECT_EQ(robot.window().model().history().count(), 1);
    expect_mesh(robot, expected);
    expect_saved(robot, expected);
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
    const Document expected = document_of(
        {{.radius = 0.15}, {.parent = 0, .position = Vec3(0, 0, 3), .radius = 1.2, .type = NodeType::ball}});
    expect_drawn(robot.document(), expected);
    expect_mesh(robot, expected);
    expect_saved(robot, expected);
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
    Document expected = document_of({{.radius = 0.2},
                                     {.parent = 0, .position = Vec3(1, 0, 0), .radius = 0.2},
                                     {.parent = 1, .position = Vec3(1, 0, 2), .radius = 0.2},
                                     {.parent = 2, .position = Vec3(1, 0, 4), .radius = 0.2},
                                     {.parent = 2, .position = Vec3(0, 0, 2), .radius = 0.2},
                                     {.parent = 3, .position = Vec3(0, 0, 4), .radius = 0.2}});
    expect_drawn(robot.document(), expected);
    expect_mesh(robot, expected);
    EXPECT_EQ(robot.window().meshes().mesh()->cycles, 2);
    robot.screenshot("04-ladder");
    // A strut down the middle: a link from rung to rung, which closes one more cycle.
    robot.click({0, 0, 2});
    robot.key(Qt::Key_L);
    robot.move({0, 0, 4});
    robot.screenshot("05-linking");
    robot.click({0, 0, 4});
    expected.links = {{4, 5}};
    expect_drawn(robot.document(), expected);
    expect_mesh(robot, expected);
    EXPECT_EQ(robot.window().meshes().mesh()->cycles, 3);
    expect_saved(robot, expected);
    expect_undo_and_redo_of_all(robot);
}

TEST(Window, what_is_drawn_on_the_image_goes_to_the_drawn_side) {
    Robot robot;
    robot.look_from_front();
    robot.drag({0, 0, 0}, {2, 0, 1}, Qt::ControlModifier);
    robot.drag({-2, 0, 1}, {-3, 0, 2}, Qt::ControlModifier);
    const Document expected = document_of({{.radius = 0.5},
                                           {.parent = 0, .position = Vec3(2, 0, 1), .radius = 0.5},
                                           {.parent = 1, .position = Vec3(3, 0, 2), .radius = 0.5}});
    expect_drawn(robot.document(), expected);
    expect_mesh(robot, expected);
}

}  // namespace
}  // namespace sinew::modeler
