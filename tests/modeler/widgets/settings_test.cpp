#include "window/settings.h"

#include <gtest/gtest.h>

#include <QSettings>

namespace sinew::modeler {
namespace {

struct Settings : testing::Test {
    void SetUp() override { QSettings().clear(); }
    void TearDown() override { QSettings().clear(); }
};

TEST_F(Settings, without_any_all_is_as_it_comes) {
    ViewSettings view;
    load_view_settings(view);
    EXPECT_EQ(view, ViewSettings{});
}

TEST_F(Settings, what_was_chosen_comes_back) {
    ViewSettings chosen;
    chosen.level = 3;
    chosen.shading = Shading::flat;
    chosen.opacity = 0.6;
    chosen.wire = chosen.grid = false;
    chosen.irregular = chosen.creases = chosen.names = true;
    save_view_settings(chosen);
    ViewSettings view;
    load_view_settings(view);
    EXPECT_EQ(view, chosen);
}

TEST_F(Settings, a_day_starts_with_mesh_and_bones) {
    ViewSettings chosen;
    chosen.live = chosen.bones = false;  // who forgets it would see nothing
    save_view_settings(chosen);
    ViewSettings view;
    load_view_settings(view);
    EXPECT_TRUE(view.live);
    EXPECT_TRUE(view.bones);
}

TEST_F(Settings, what_somebody_wrote_there_does_no_harm) {
    QSettings settings;
    settings.setValue("view/level", 77);
    settings.setValue("view/shading", "shiny");
    settings.setValue("view/opacity", -3);
    ViewSettings view;
    load_view_settings(view);
    EXPECT_EQ(view.level, most_levels);
    EXPECT_LE(static_cast<int>(view.shading), 2);
    EXPECT_GT(view.opacity, 0);
}

}  // namespace
}  // namespace sinew::modeler
