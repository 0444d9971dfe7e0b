#include "panels/problems.h"

#include <gmock/gmock.h>

#include <QTest>

#include "tree.h"

namespace sinew::modeler {
namespace {

using testing::ElementsAre;

struct Panel : Shown {
    Problems problems{model};
    int count = -1;
    Panel() {
        problems.counted = [this](int n) { count = n; };
        problems.resize(300, 200);
        problems.show();
    }
    void click(int row) {
        QTest::mouseClick(problems.viewport(), Qt::LeftButton, {},
                          problems.visualItemRect(problems.item(row)).center());
    }
};

Document with_a_cone_inside(Document document) {
    return set(std::move(document), std::vector<std::int32_t>{1}, &Node::type, NodeType::cone);
}

TEST(Problems, a_sound_document_has_none) {
    Panel panel;
    panel.model.apply("Move", translate(panel.model.document(), std::vector<std::int32_t>{2}, Vec3(1, 0, 0)));
    EXPECT_EQ(panel.count, 0);
}

TEST(Problems, a_click_selects_the_node) {
    Panel panel;
    panel.model.apply("Type", with_a_cone_inside(panel.model.document()), {});
    ASSERT_EQ(panel.count, 1);
    EXPECT_TRUE(panel.problems.item(0)->text().contains("node 1"));
    panel.click(0);
    EXPECT_THAT(panel.model.selection().nodes, ElementsAre(1));
    panel.model.undo();
    EXPECT_EQ(panel.count, 0);
}

TEST(Problems, what_skinning_says_is_listed_once) {
    Panel panel;
    panel.model.apply("Type", with_a_cone_inside(panel.model.document()));
    // The mesher finds what validation has found already.
    panel.problems.show_mesh(std::make_shared<LiveMesh>(Pipeline().run(panel.model.document(), {})));
    EXPECT_EQ(panel.count, 1);
    panel.model.undo();
    LiveMesh mesh;
    mesh.warnings = {{"two nodes were merged", 2, {3, 4}}};
    panel.problems.show_mesh(std::make_shared<LiveMesh>(mesh));
    ASSERT_EQ(panel.count, 1);
    panel.click(0);
    EXPECT_THAT(panel.model.selection().nodes, ElementsAre(3, 4));
}

TEST(Problems, remarks_of_reading_go_with_the_document) {
    Panel panel;
    panel.problems.show_reading({{"a radius was guessed", 1, {2}}});
    EXPECT_EQ(panel.count, 1);
    panel.model.replace(small_tree(), true);
    EXPECT_EQ(panel.count, 0);
}

TEST(Problems, nothing_is_counted_while_one_drags) {
    Panel panel;
    panel.model.preview(with_a_cone_inside(panel.model.document()), {});
    EXPECT_EQ(panel.problems.count(), 0);
    panel.model.commit("Type");
    EXPECT_EQ(panel.problems.count(), 1);
}

}  // namespace
}  // namespace sinew::modeler
