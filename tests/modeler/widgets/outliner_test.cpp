#include "panels/outliner.h"

#include <gmock/gmock.h>

#include <QApplication>
#include <QLineEdit>
#include <QTest>

#include "tree.h"

namespace sinew::modeler {
namespace {

using testing::ElementsAre;

struct Panel : Shown {
    Outliner outliner{model};
    Panel() {
        outliner.resize(300, 400);
        outliner.show();
        QApplication::setActiveWindow(&outliner);
    }
    const OutlinerModel& items() const { return static_cast<const OutlinerModel&>(*outliner.model()); }
    void click(std::int32_t node, Qt::KeyboardModifiers held = {}) {
        const QRect row = outliner.visualRect(items().index_of(node));
        QTest::mouseClick(outliner.viewport(), Qt::LeftButton, held, row.center());
    }
};

TEST(Outliner, selects_what_is_clicked) {
    Panel panel;
    panel.click(3);
    EXPECT_THAT(panel.model.selection().nodes, ElementsAre(3));
    panel.click(2, Qt::ControlModifier);
    EXPECT_THAT(panel.model.selection().nodes, ElementsAre(2, 3));
    EXPECT_EQ(panel.model.selection().active, 2);
    panel.click(4, Qt::ShiftModifier);  // all rows from the one before to this
    EXPECT_THAT(panel.model.selection().nodes, ElementsAre(2, 3, 4));
}

TEST(Outliner, shows_what_is_selected_elsewhere) {
    Panel panel;
    panel.select({1, 4});
    std::vector<std::int32_t> shown;
    for (const QModelIndex& index : panel.outliner.selectionModel()->selectedIndexes())
        shown.push_back(OutlinerModel::node_of(index));
    EXPECT_THAT(shown, testing::UnorderedElementsAre(1, 4));
    panel.select({});
    EXPECT_FALSE(panel.outliner.selectionModel()->hasSelection());
    EXPECT_THAT(panel.model.selection().nodes, ElementsAre());
}

TEST(Outliner, keeps_the_selection_when_the_tree_changes) {
    Panel panel;
    panel.select({3});
    panel.model.apply("Rename", rename(panel.model.document(), 2, "arm"));
    EXPECT_THAT(panel.model.selection().nodes, ElementsAre(3));
    EXPECT_EQ(panel.outliner.selectionModel()->selectedIndexes().size(), 1);
    EXPECT_TRUE(panel.outliner.isExpanded(panel.items().index_of(1)));
}

TEST(Outliner, a_name_is_typed_in_place) {
    Panel panel;
    panel.select({2});
    panel.outliner.rename_active();
    auto* editor = panel.outliner.viewport()->findChild<QLineEdit*>();
    ASSERT_TRUE(editor);
    QTest::keyClicks(editor, "left arm");
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(panel.model.document().names[2], std::string("left arm"), 60000);
}

}  // namespace
}  // namespace sinew::modeler
