#include "panels/properties.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <QWheelEvent>

#include "document/delta.h"
#include "tree.h"

namespace sinew::modeler {
namespace {

struct Panel : Shown {
    Properties properties{model};
    Panel() {
        properties.resize(320, 700);
        properties.show();
    }
    template <class Widget>
    Widget& find(const char* name) {
        return *properties.findChild<Widget*>(name);
    }
    QDoubleSpinBox& box(const char* field) { return find<QDoubleSpinBox>(field); }
    bool shows(const char* field) { return !box(field).isHidden(); }
    void type(const char* field, const QString& text) {
        QDoubleSpinBox& number = box(field);
        number.setFocus();
        number.selectAll();
        QTest::keyClicks(&number, text);
        QTest::keyClick(&number, Qt::Key_Return);
    }
    void choose(const char* name, const QString& text) {
        auto& choice = find<QComboBox>(name);
        choice.setFocus();
        QTest::keyClick(&choice, Qt::Key_Home);
        for (int i = 0; i < choice.count() && choice.currentText() != text; ++i)
            QTest::keyClick(&choice, Qt::Key_Down);
        EXPECT_EQ(choice.currentText(), text);
    }
    const Node& node(int i) { return model.document().nodes[i]; }
};

TEST(Properties, show_the_node_that_is_selected) {
    Panel panel;
    panel.select({2});
    EXPECT_EQ(panel.box("x").value(), 1);
    EXPECT_EQ(panel.box("z").value(), 3);
    EXPECT_EQ(panel.box("radius").text(), "0.25 m");
    EXPECT_EQ(panel.find<QComboBox>("type").currentText(), "Sphere");
    EXPECT_TRUE(panel.find<QLabel>("properties_title").text().contains("Node 2"));
    EXPECT_FALSE(panel.shows("size_x"));
    panel.select({});
    EXPECT_FALSE(panel.shows("radius"));
    EXPECT_TRUE(panel.find<QLabel>("properties_title").text().contains("Nothing selected"));
}

TEST(Properties, every_field_has_a_row_where_it_means_something) {
    Panel panel;
    for (const NodeType type : {NodeType::sphere, NodeType::cube, NodeType::ball}) {
        panel.model.apply("Type", set_type(panel.model.document(), std::vector<std::int32_t>{4}, type));
        panel.select({4});
        for (const Field& field : fields())
            EXPECT_EQ(panel.shows(field.id),
                      relevant_to_all(panel.model.document(), std::vector<std::int32_t>{4}, field))
                << field.id;
    }
}

TEST(Properties, figures_that_are_typed_are_steps) {
    Panel panel;
    panel.select({2});
    panel.type("radius", "0.75");
    EXPECT_EQ(panel.node(2).radius, 0.75);
    panel.type("y", "-1.5");
    EXPECT_EQ(panel.node(2).position, Vec3(1, -1.5, 3));
    EXPECT_EQ(panel.model.history().count(), 2);
    panel.model.undo();
    EXPECT_EQ(panel.box("y").value(), 0);
    panel.model.undo();
    EXPECT_TRUE(same(panel.model.document(), small_tree()));
}

TEST(Properties, several_nodes_change_together) {
    Panel panel;
    panel.select({2, 3, 4});
    EXPECT_EQ(panel.box("radius").value(), 0.25);
    EXPECT_EQ(panel.box("x").text(), "");  // they differ
    panel.type("radius", "0.5");
    panel.type("x", "7");
    for (const int i : {2, 3, 4}) {
        EXPECT_EQ(panel.node(i).radius, 0.5);
        EXPECT_EQ(panel.node(i).position.x(), 7);
    }
    EXPECT_EQ(panel.node(1).radius, 0.25);
    EXPECT_EQ(panel.box("x").text(), "7 m");
}

TEST(Properties, the_value_of_the_first_can_be_given_to_all) {
    Panel panel;
    panel.select({2, 3});
    panel.type("x", "1");  // node 2 has it already, node 3 has not
    EXPECT_EQ(panel.node(3).position.x(), 1);
}

TEST(Properties, looking_at_several_and_back_changes_nothing) {
    Panel panel;
    for (const std::vector<std::int32_t>& nodes :
         {std::vector<std::int32_t>{2}, {2, 3}, {2}, {0, 1, 2, 3, 4}, {}, {3}})
        panel.select(nodes);
    EXPECT_EQ(panel.box("x").text(), "-1 m");
    EXPECT_TRUE(same(panel.model.document(), small_tree()));
    EXPECT_EQ(panel.model.history().count(), 0);
}

TEST(Properties, type_and_section_are_chosen_for_all) {
    Panel panel;
    panel.select({2, 4});
    panel.choose("type", "Cone");
    panel.choose("section", "Rectangular");
    for (const int i : {2, 4}) {
        EXPECT_EQ(panel.node(i).type, NodeType::cone);
        EXPECT_EQ(panel.node(i).section, Section::rectangular);
    }
    panel.select({1, 2});
    EXPECT_EQ(panel.find<QComboBox>("type").currentIndex(), -1);  // a sphere and a cone
}

TEST(Properties, a_name_is_for_one_node) {
    Panel panel;
    panel.select({4});
    auto& name = panel.find<QLineEdit>("name");
    EXPECT_EQ(name.text(), "hand");
    name.setFocus();
    name.selectAll();
    QTest::keyClicks(&name, "paw");
    QTest::keyClick(&name, Qt::Key_Return);
    EXPECT_EQ(panel.model.document().names[4], "paw");
    panel.select({3, 4});
    EXPECT_FALSE(name.isEnabled());
    EXPECT_EQ(name.text(), "");
}

TEST(Properties, scrolling_past_a_number_does_not_change_it) {
    Panel panel;
    panel.select({2});
    panel.properties.setFocus();
    QWheelEvent wheel({5, 5}, panel.box("radius").mapToGlobal(QPointF(5, 5)), {}, {0, 120}, Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&panel.box("radius"), &wheel);
    EXPECT_EQ(panel.node(2).radius, 0.25);
}

TEST(Properties, of_nothing_are_those_of_the_document) {
    Panel panel;
    panel.select({1});
    EXPECT_TRUE(panel.find<QComboBox>("unit").isHidden());
    panel.select({});
    auto& unit = panel.find<QComboBox>("unit");
    EXPECT_FALSE(unit.isHidden());
    EXPECT_EQ(unit.currentText(), "m");
    unit.setFocus();
    unit.lineEdit()->selectAll();
    QTest::keyClicks(unit.lineEdit(), "inch");
    QTest::keyClick(unit.lineEdit(), Qt::Key_Return);
    EXPECT_EQ(panel.model.document().unit, "inch");
    EXPECT_EQ(panel.model.history().undoText(), "Unit");
    panel.model.undo();
    EXPECT_TRUE(same(panel.model.document(), small_tree()));
}

}  // namespace
}  // namespace sinew::modeler
