#include "panels/outliner_model.h"

#include <gmock/gmock.h>

#include <QAbstractItemModelTester>
#include <QIcon>
#include <QMimeData>

#include "document/delta.h"
#include "tree.h"

namespace sinew::modeler {
namespace {

/// Qt's own tester ends the program where the model breaks a rule of item models.
struct Tree : Shown {
    OutlinerModel items{model};
    QAbstractItemModelTester tester{&items, QAbstractItemModelTester::FailureReportingMode::Fatal};

    bool drop(std::int32_t node, std::int32_t onto) {
        const std::unique_ptr<QMimeData> data(items.mimeData({items.index_of(node)}));
        const QModelIndex target = items.index_of(onto);
        if (!items.canDropMimeData(data.get(), Qt::MoveAction, -1, -1, target)) return false;
        items.dropMimeData(data.get(), Qt::MoveAction, -1, -1, target);
        return true;
    }
};

TEST(OutlinerModel, is_the_tree_of_the_document) {
    Tree tree;
    const Document& document = tree.model.document();
    for (std::int32_t i = 0; i < std::ssize(document.nodes); ++i) {
        const QModelIndex index = tree.items.index_of(i), above = tree.items.parent(index);
        EXPECT_EQ(OutlinerModel::node_of(index), i);
        EXPECT_EQ(above.isValid() ? OutlinerModel::node_of(above) : -1, document.nodes[i].parent);
    }
    EXPECT_EQ(tree.items.rowCount({}), 1);
    EXPECT_EQ(tree.items.rowCount(tree.items.index_of(1)), 2);
    EXPECT_EQ(tree.items.rowCount(tree.items.index_of(4)), 0);
    EXPECT_FALSE(tree.items.index_of(-1).isValid());
    EXPECT_FALSE(tree.items.index_of(5).isValid());
}

TEST(OutlinerModel, calls_nodes_by_name_or_else_by_type) {
    Tree tree;
    EXPECT_EQ(tree.items.index_of(4).data().toString(), "hand");
    EXPECT_EQ(tree.items.index_of(0).data().toString(), "Root 0");
    EXPECT_EQ(tree.items.index_of(2).data().toString(), "Node 2");
    tree.model.apply("Type", set_type(tree.model.document(), std::vector<std::int32_t>{2}, NodeType::cone));
    EXPECT_EQ(tree.items.index_of(2).data().toString(), "Cone 2");
    EXPECT_EQ(tree.items.index_of(2).data(Qt::EditRole).toString(), "");
    EXPECT_FALSE(tree.items.index_of(2).data(Qt::DecorationRole).value<QIcon>().isNull());
}

TEST(OutlinerModel, follows_edits_and_undo) {
    Tree tree;
    tree.model.apply("Delete", erase_nodes(tree.model.document(), selection_of(1)).document, {});
    EXPECT_EQ(tree.items.rowCount(tree.items.index_of(0)), 2);
    tree.model.undo();
    EXPECT_EQ(tree.items.rowCount(tree.items.index_of(0)), 1);
    tree.model.replace({}, true);
    EXPECT_EQ(tree.items.rowCount({}), 0);
}

TEST(OutlinerModel, a_move_in_space_keeps_every_index) {
    Tree tree;
    const QPersistentModelIndex index = tree.items.index_of(3);
    int resets = 0;
    QObject::connect(&tree.items, &QAbstractItemModel::modelReset, [&] { ++resets; });
    tree.model.apply("Move", translate(tree.model.document(), std::vector<std::int32_t>{3}, Vec3(1, 1, 1)));
    EXPECT_EQ(resets, 0);
    EXPECT_TRUE(index.isValid());
}

TEST(OutlinerModel, a_new_label_is_told_of_that_node_alone) {
    Tree tree;
    std::vector<std::int32_t> told;
    int resets = 0;
    QObject::connect(&tree.items, &QAbstractItemModel::modelReset, [&] { ++resets; });
    QObject::connect(&tree.items, &QAbstractItemModel::dataChanged,
                     [&](const QModelIndex& index) { told.push_back(OutlinerModel::node_of(index)); });
    tree.model.apply("Rename", rename(tree.model.document(), 2, "arm"));
    tree.model.apply("Type", set_type(tree.model.document(), std::vector<std::int32_t>{4}, NodeType::cone));
    EXPECT_THAT(told, testing::ElementsAre(2, 4));
    EXPECT_EQ(resets, 0);
}

TEST(OutlinerModel, a_new_name_is_a_step) {
    Tree tree;
    EXPECT_TRUE(tree.items.setData(tree.items.index_of(2), "  left arm ", Qt::EditRole));
    EXPECT_EQ(tree.model.document().names[2], "left arm");
    EXPECT_EQ(tree.model.history().undoText(), "Rename");
    tree.model.undo();
    EXPECT_EQ(tree.items.index_of(2).data().toString(), "Node 2");
}

TEST(OutlinerModel, a_node_dropped_on_another_is_its_child) {
    Tree tree;
    ASSERT_TRUE(tree.drop(3, 0));
    EXPECT_EQ(tree.model.document().nodes[3].parent, 0);
    EXPECT_EQ(tree.model.document().nodes[4].parent, 3);  // what hangs on it comes along
    ASSERT_TRUE(tree.drop(3, -1));
    EXPECT_EQ(tree.model.document().nodes[3].parent, -1);
    tree.model.undo();
    tree.model.undo();
    EXPECT_TRUE(same(tree.model.document(), small_tree()));
}

TEST(OutlinerModel, nobody_hangs_on_themselves_or_their_children) {
    Tree tree;
    EXPECT_FALSE(tree.drop(1, 4));
    EXPECT_FALSE(tree.drop(1, 1));
    QMimeData text;
    text.setText("3");
    EXPECT_FALSE(tree.items.canDropMimeData(&text, Qt::MoveAction, -1, -1, tree.items.index_of(0)));
    EXPECT_TRUE(same(tree.model.document(), small_tree()));
}

}  // namespace
}  // namespace sinew::modeler
