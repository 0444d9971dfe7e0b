#include "window/action_set.h"

#include <gmock/gmock.h>

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <set>

#include "desk_window.h"

namespace sinew::modeler {
namespace {

/// The ids of the actions in a menu and its submenus.
void gather(const QMenu& menu, std::multiset<std::string>& ids) {
    for (const QAction* action : menu.actions()) {
        if (action->menu()) gather(*action->menu(), ids);
        if (!action->menu() && !action->isSeparator()) ids.insert(action->objectName().toStdString());
    }
}

TEST(ActionSet, the_menus_hold_each_action_once) {
    DeskWindow desk;
    desk.actions.fill(*desk.window.menuBar());
    std::multiset<std::string> ids;
    for (const QAction* menu : desk.window.menuBar()->actions()) gather(*menu->menu(), ids);
    EXPECT_EQ(ids.size(), actions().size());
    for (const Action& action : actions()) EXPECT_EQ(ids.count(action.id), 1u) << action.id;
}

TEST(ActionSet, what_is_in_the_toolbar_has_an_icon) {
    DeskWindow desk;
    QToolBar bar;
    desk.actions.fill(bar);
    int shown = 0;
    for (const QAction* action : bar.actions()) {
        if (action->isSeparator()) continue;
        ++shown;
        EXPECT_FALSE(action->icon().isNull()) << action->objectName().toStdString();
        EXPECT_TRUE(find_action(action->objectName().toStdString())->in_toolbar);
    }
    EXPECT_GT(shown, 5);
}

TEST(ActionSet, every_action_has_its_keys_and_its_tip) {
    DeskWindow desk;
    for (const Action& action : actions()) {
        const QAction* made = desk.actions.find(action.id);
        ASSERT_TRUE(made) << action.id;
        EXPECT_EQ(made->shortcuts().isEmpty(), std::string_view(action.shortcut).empty()) << action.id;
        EXPECT_TRUE(made->toolTip().contains(action.tip)) << action.id;
        EXPECT_EQ(made->isCheckable(), action.checked != nullptr) << action.id;
    }
}

TEST(ActionSet, enabled_and_checked_follow_the_model) {
    DeskWindow desk;
    desk.actions.refresh();
    EXPECT_FALSE(desk.actions.find("edit.delete")->isEnabled());
    desk.desk.model.select(selection_of(2));
    desk.desk.view.wire = false;
    desk.actions.refresh();
    EXPECT_TRUE(desk.actions.find("edit.delete")->isEnabled());
    EXPECT_FALSE(desk.actions.find("view.wire")->isChecked());
    desk.actions.find("view.wire")->trigger();
    EXPECT_TRUE(desk.desk.view.wire);
    EXPECT_TRUE(desk.actions.find("view.wire")->isChecked());
    EXPECT_EQ(desk.ran, 1);
}

TEST(ActionSet, undo_says_what_it_takes_back) {
    DeskWindow desk;
    desk.desk.model.select(selection_of(2));
    desk.actions.find("edit.delete")->trigger();
    EXPECT_EQ(desk.actions.find("edit.undo")->text(), "Undo delete");
    desk.actions.find("edit.undo")->trigger();
    EXPECT_EQ(desk.actions.find("edit.redo")->text(), "Redo delete");
    EXPECT_EQ(desk.actions.find("edit.undo")->text(), "Undo");
}

TEST(ActionSet, what_is_not_enabled_does_not_run) {
    DeskWindow desk;
    desk.actions.run(*find_action("edit.delete"));
    EXPECT_EQ(desk.desk.model.document().nodes.size(), 5u);
    EXPECT_EQ(desk.desk.model.history().count(), 0);
}

}  // namespace
}  // namespace sinew::modeler
