#include "panels/statistics.h"

#include <gtest/gtest.h>

#include <QLabel>

#include "tree.h"

namespace sinew::modeler {
namespace {

struct Panel : Shown {
    Statistics statistics{model};
    QString text(const char* name) {
        return statistics.findChild<QLabel*>(QString("statistics_") + name)->text();
    }
    std::shared_ptr<LiveMesh> made(int level) {
        auto mesh = std::make_shared<LiveMesh>(Pipeline().run(model.document(), {.level = level}));
        if (mesh->mesh) measure(*mesh);
        return mesh;
    }
};

TEST(Statistics, count_the_skeleton) {
    Panel panel;
    EXPECT_EQ(panel.text("nodes"), "5");
    EXPECT_EQ(panel.text("bones"), "4");
    EXPECT_EQ(panel.text("parts"), "1, 0");
    panel.model.apply("Link", toggle_link(panel.model.document(), 2, 4));
    EXPECT_EQ(panel.text("bones"), "5");
    EXPECT_EQ(panel.text("parts"), "1, 1");
}

TEST(Statistics, count_the_mesh) {
    Panel panel;
    const auto mesh = panel.made(0);
    panel.statistics.show_mesh(mesh);
    EXPECT_EQ(panel.text("vertices"), QString::number(mesh->mesh->vertex_count()));
    EXPECT_EQ(panel.text("quads").toInt() + panel.text("triangles").toInt(), mesh->mesh->face_count());
    // A branch of three bones has 2 vertices of valence 6; each of the three tips has a pole.
    EXPECT_TRUE(panel.text("irregular").endsWith("of at most 5")) << panel.text("irregular").toStdString();
    EXPECT_TRUE(panel.text("closed").contains("closed, manifold"));
    EXPECT_TRUE(panel.text("time").contains("ms"));
}

TEST(Statistics, are_all_of_one_mesh) {
    Panel panel;
    panel.statistics.show_mesh(panel.made(0));
    const QString vertices = panel.text("vertices"), quads = panel.text("quads");
    const auto finer = panel.made(1);
    auto not_measured = std::make_shared<LiveMesh>(*finer);
    not_measured->measures.reset();
    panel.statistics.show_mesh(not_measured);
    EXPECT_EQ(panel.text("vertices"), vertices);
    EXPECT_EQ(panel.text("quads"), quads);
    panel.statistics.show_mesh(finer);
    EXPECT_NE(panel.text("vertices"), vertices);
    EXPECT_NE(panel.text("quads"), quads);
}

TEST(Statistics, say_nothing_of_a_mesh_that_is_not_there) {
    Panel panel;
    panel.statistics.show_mesh(panel.made(1));
    panel.model.apply("Radius",
                      set(panel.model.document(), std::vector<std::int32_t>{1}, &Node::type, NodeType::cone));
    panel.statistics.show_mesh(panel.made(1));
    for (const char* name : {"vertices", "quads", "triangles", "irregular", "closed", "time"})
        EXPECT_EQ(panel.text(name), "-") << name;
}

}  // namespace
}  // namespace sinew::modeler
