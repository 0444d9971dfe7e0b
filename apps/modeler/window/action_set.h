/// @file action_set.h
/// The table of actions as Qt's menus, toolbar and shortcuts.
#pragma once

#include <QHash>
#include <functional>

#include "actions/action.h"

class QAction;
class QMainWindow;
class QMenu;
class QMenuBar;
class QToolBar;

namespace sinew::modeler {

class ActionSet {
  public:
    /// @param owner  the window whose shortcuts they are
    /// @param ran    called after every action
    ActionSet(Context& context, QMainWindow& owner, std::function<void()> ran);

    void fill(QMenuBar& bar);
    void fill(QToolBar& bar);
    void fill_context_menu(QMenu& menu);

    /// Only the view can be changed: something else holds the document (see GrowDialog).
    void lock(bool locked);

    /// What is enabled and checked follows the model and the settings.
    void refresh();
    void run(const Action& action);
    QAction* find(std::string_view id) const;
    /// The menu of the bar, to put more into it.
    QMenu* menu(Menu menu) const { return menus_.value(static_cast<int>(menu)); }

    /// How a shortcut is written for people: the first one, in the words of the platform.
    static QString shortcut_text(const Action& action);

  private:
    void add_to(QMenu& menu, const Action& action, QHash<QString, QMenu*>& submenus);

    bool may_run(const Action& action) const;

    Context& context_;
    bool locked_ = false;
    std::function<void()> ran_;
    QHash<QString, QAction*> actions_;
    QHash<int, QMenu*> menus_;
};

}  // namespace sinew::modeler
