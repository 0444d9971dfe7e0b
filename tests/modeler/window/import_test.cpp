// Skeletons of other programs come to the one at hand.

#include <gmock/gmock.h>

#include <QFile>

#include "document/delta.h"
#include "document/edits.h"
#include "robot.h"
#include "sinew/io/files.h"
#include "sinew/skeleton/validate.h"

namespace sinew::modeler {
namespace {

/// Three joints in a row, one unit apart, upwards in glTF's sense.
const char* const joints = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"name": "hip", "children": [1]}, {"name": "knee", "translation": [0, 1, 0], "children": [2]},
              {"name": "foot", "translation": [0, 1, 0]}],
    "skins": [{"joints": [0, 1, 2]}]})";

struct Case {
    const char* name;
    const char* text;
    std::size_t nodes;
};
const Case cases[] = {
    {"cell.swc", "1 1 0 0 0 1 -1\n2 3 0 0 4 0.5 1\n3 3 2 0 8 0.3 2\n4 3 -2 0 8 0.3 2\n", 4},
    {"square.graph", "n 0 0 0 0.2\nn 4 0 0 0.2\nn 4 0 4 0.2\nn 0 0 4 0.2\nc 0 1\nc 1 2\nc 2 3\nc 3 0\n", 4},
    {"rig.gltf", joints, 3},
};

TEST(Importing, what_comes_is_selected_and_stands_beside_what_was_there) {
    for (const Case& each : cases) {
        SCOPED_TRACE(each.name);
        const TemporaryFolder folder;
        ASSERT_TRUE(write_file(folder.file(each.name), each.text));
        Robot robot;
        robot.when_asked_for_file("open_dialog", QString::fromStdString(folder.file(each.name)));
        robot.key(Qt::Key_I, Qt::ControlModifier);
        ASSERT_EQ(robot.document().nodes.size(), 1 + each.nodes);
        EXPECT_TRUE(validate(robot.document()));
        EXPECT_EQ(robot.window().model().selection().nodes.size(), each.nodes);
        EXPECT_FALSE(robot.window().model().selection().contains(0));
        EXPECT_EQ(robot.window().model().history().undoText(), "Import");
        EXPECT_TRUE(robot.window().isWindowModified());
        ASSERT_TRUE(robot.wait_for_mesh());
        ASSERT_FALSE(robot.window().meshes().mesh()->error) << robot.window().meshes().mesh()->error->text();
        EXPECT_TRUE(robot.window().meshes().mesh()->validation->solid());
        robot.screenshot(std::string("15-imported-") + QString(each.name).section('.', 1).toStdString());
        robot.key(Qt::Key_Z, Qt::ControlModifier);
        EXPECT_TRUE(same(robot.document(), starting_document()));
    }
}

TEST(Importing, joints_keep_their_names) {
    const TemporaryFolder folder;
    ASSERT_TRUE(write_file(folder.file("rig.gltf"), joints));
    Robot robot(QString::fromStdString(folder.file("rig.gltf")));
    EXPECT_THAT(robot.document().names, testing::ElementsAre("hip", "knee", "foot"));
    ASSERT_EQ(robot.document().nodes.size(), 3u);
    EXPECT_NEAR((robot.document().nodes[2].position - robot.document().nodes[0].position).norm(), 2, 1e-6);
}

}  // namespace
}  // namespace sinew::modeler
