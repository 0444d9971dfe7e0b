// A thousand nodes and more, grown and opened, edited and saved by mouse and keys.

#include <gmock/gmock.h>

#include <algorithm>

#include "document/delta.h"
#include "document/edits.h"
#include "robot.h"
#include "sinew/grow/grow.h"
#include "sinew/io/files.h"
#include "sinew/io/skeleton_formats.h"

namespace sinew::modeler {
namespace {

/// The tree of figure 2.6a of "The Algorithmic Beauty of Plants": 2^10 nodes.
Document thousand_nodes() {
    const std::string text = read_file(std::string(SINEW_LSYSTEMS) + "/honda_a.lsys").value();
    return grow(*parse_grammar(text, "honda_a.lsys"), {.steps = 10, .constants = {{"w0", 0.05}}}).value();
}

struct Opened {
    TemporaryFolder folder;
    std::string path = folder.file("tree.sinew");
    Document tree = thousand_nodes();
    Opened() { EXPECT_TRUE(write_skeleton(tree, path)); }
};

/// A tip that stands free on the screen: no other node is within some pixels.
std::int32_t free_tip(Robot& robot) {
    const Document& document = robot.document();
    std::vector<bool> has_child(document.nodes.size(), false);
    for (const Node& node : document.nodes)
        if (node.parent >= 0) has_child[node.parent] = true;
    for (std::int32_t i = 0; i < std::ssize(document.nodes); ++i) {
        if (has_child[i]) continue;
        const QPoint here = robot.pixel(document.nodes[i].position);
        const auto crowds = [&](const Node& other) {
            return &other != &document.nodes[i] &&
                   (robot.pixel(other.position) - here).manhattanLength() < 12;
        };
        if (std::none_of(document.nodes.begin(), document.nodes.end(), crowds)) return i;
    }
    return -1;
}

TEST(Large, a_tree_of_a_thousand_nodes_is_opened_and_edited) {
    const Opened file;
    ASSERT_GE(file.tree.nodes.size(), 1000u);
    Robot robot;
    robot.open(QString::fromStdString(file.path));
    ASSERT_TRUE(same(robot.document(), file.tree));
    ASSERT_TRUE(robot.wait_for_mesh());
    EXPECT_TRUE(robot.window().meshes().mesh()->validation->solid());
    robot.screenshot("30-tree");

    // A twig grows at a tip, gets a ball, and goes again.
    const std::int32_t tip = free_tip(robot);
    ASSERT_GE(tip, 0);
    const Vec3 place = robot.document().nodes[tip].position;
    robot.click(place);
    ASSERT_THAT(robot.window().model().selection().nodes, testing::ElementsAre(tip));
    robot.drag(place, place * 1.1);
    ASSERT_EQ(robot.document().nodes.size(), file.tree.nodes.size() + 1);
    EXPECT_EQ(robot.document().nodes.back().parent, tip);
    robot.key(Qt::Key_6, Qt::ControlModifier);
    EXPECT_EQ(robot.document().nodes.back().type, NodeType::ball);
    ASSERT_TRUE(robot.wait_for_mesh());
    EXPECT_TRUE(robot.window().meshes().mesh()->validation->solid());
    robot.screenshot("31-tree-edited");
    robot.key(Qt::Key_X);
    EXPECT_EQ(robot.document().nodes.size(), file.tree.nodes.size());

    // All of it thicker, and back.
    robot.key(Qt::Key_A, Qt::ControlModifier);
    EXPECT_EQ(robot.window().model().selection().nodes.size(), file.tree.nodes.size());
    robot.key(Qt::Key_S);
    robot.type("1.5");
    robot.key(Qt::Key_Return);
    EXPECT_NEAR(robot.document().nodes[7].radius, 1.5 * file.tree.nodes[7].radius, 1e-12);
    while (robot.window().model().history().canUndo()) robot.key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(same(robot.document(), file.tree));
    EXPECT_FALSE(robot.window().isWindowModified());
}

TEST(Large, the_window_does_not_wait_for_the_mesh) {
    // Every move of a drag over all nodes is in the document as soon as the event is through, whether there
    // is a mesh or not; and in the end the mesh is that of the last.
    const Opened file;
    Robot robot(QString::fromStdString(file.path));
    robot.key(Qt::Key_2);
    robot.key(Qt::Key_A, Qt::ControlModifier);
    robot.move(Vec3(0, 0, 0));
    robot.key(Qt::Key_G);
    Vec3 last = robot.document().nodes[0].position;
    for (int i = 1; i <= 6; ++i) {
        robot.move(Vec3(0, 0, 0.1 * i));
        const Vec3 now = robot.document().nodes[0].position;
        EXPECT_NE(now, last);
        last = now;
    }
    robot.key(Qt::Key_Return);
    ASSERT_TRUE(robot.wait_for_mesh());
    const auto& shown = robot.window().meshes().mesh();
    EXPECT_EQ(shown->revision, robot.window().model().revision());
    EXPECT_TRUE(shown->validation->solid());
}

}  // namespace
}  // namespace sinew::modeler
