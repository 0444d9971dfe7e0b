#include "window/action_set.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>

#include "look/icons.h"

namespace sinew::modeler {
namespace {

QString last_part(const Action& action) { return QString(action.name).section(" > ", -1); }

QList<QKeySequence> shortcuts_of(const Action& action) {
    QList<QKeySequence> keys;
    for (const QString& text : QString(action.shortcut).split(" | ", Qt::SkipEmptyParts))
        keys.append(QKeySequence::fromString(text, QKeySequence::PortableText));
    return keys;
}

QString tooltip_of(const Action& action) {
    const QString keys = ActionSet::shortcut_text(action);
    return QString("<b>%1</b>%2<br>%3")
        .arg(last_part(action),
             keys.isEmpty() ? "" : "&nbsp;&nbsp;<span style='color:#98a0ad'>" + keys + "</span>", action.tip);
}

}  // namespace

ActionSet::ActionSet(Context& context, QMainWindow& owner, std::function<void()> ran)
    : context_(context), ran_(std::move(ran)) {
    for (const Action& action : actions()) {
        QAction* made = new QAction(icon(action.id), last_part(action), &owner);
        made->setObjectName(action.id);
        made->setShortcuts(shortcuts_of(action));
        made->setToolTip(tooltip_of(action));
        made->setStatusTip(action.tip);
        made->setCheckable(action.checked != nullptr);
        QObject::connect(made, &QAction::triggered, &owner, [this, &action] { run(action); });
        owner.addAction(made);
        actions_.insert(action.id, made);
    }
}

bool ActionSet::may_run(const Action& action) const {
    if (locked_ && action.menu != Menu::view && action.menu != Menu::help) return false;
    return !action.enabled || action.enabled(context_);
}

void ActionSet::lock(bool locked) {
    locked_ = locked;
    refresh();
}

void ActionSet::run(const Action& action) {
    if (may_run(action)) action.run(context_);
    refresh();
    ran_();
}

QAction* ActionSet::find(std::string_view id) const {
    return actions_.value(QString::fromUtf8(id.data(), static_cast<qsizetype>(id.size())));
}

QString ActionSet::shortcut_text(const Action& action) {
    const QList<QKeySequence> keys = shortcuts_of(action);
    return keys.isEmpty() ? QString() : keys.first().toString(QKeySequence::NativeText);
}

void ActionSet::add_to(QMenu& menu, const Action& action, QHash<QString, QMenu*>& submenus) {
    if (action.separated) menu.addSeparator();
    const QString name = action.name;
    if (!name.contains(" > ")) return menu.addAction(find(action.id));
    const QString title = name.section(" > ", 0, 0);
    if (!submenus.contains(title)) submenus.insert(title, menu.addMenu(title));
    submenus.value(title)->addAction(find(action.id));
}

void ActionSet::fill(QMenuBar& bar) {
    QHash<QString, QMenu*> submenus;
    for (const Action& action : actions()) {
        QMenu*& menu = menus_[static_cast<int>(action.menu)];
        if (!menu) {
            const std::string_view name = name_of(action.menu);
            menu = bar.addMenu("&" + QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())));
            menu->setToolTipsVisible(true);
            submenus.clear();
        }
        add_to(*menu, action, submenus);
    }
    for (auto menu : menus_) QObject::connect(menu, &QMenu::aboutToShow, menu, [this] { refresh(); });
}

void ActionSet::fill(QToolBar& bar) {
    // Tools first, then what one does less often; what belongs to the view has a bar of its own.
    for (Menu part : {Menu::skeleton, Menu::edit, Menu::file}) {
        if (!bar.actions().isEmpty()) bar.addSeparator();
        for (const Action& action : actions())
            if (action.menu == part && action.in_toolbar) bar.addAction(find(action.id));
    }
}

void ActionSet::fill_context_menu(QMenu& menu) {
    QHash<QString, QMenu*> submenus;
    for (Menu part : {Menu::skeleton, Menu::edit, Menu::select, Menu::view}) {
        if (!menu.isEmpty()) menu.addSeparator();
        for (const Action& action : actions())
            if (action.menu == part && action.in_context_menu) add_to(menu, action, submenus);
    }
    refresh();
}

void ActionSet::refresh() {
    for (const Action& action : actions()) {
        QAction* shown = find(action.id);
        shown->setEnabled(may_run(action));
        if (action.checked) shown->setChecked(action.checked(context_));
    }
    const QUndoStack& history = context_.model.history();
    find("edit.undo")->setText(history.canUndo() ? "Undo " + history.undoText().toLower() : "Undo");
    find("edit.redo")->setText(history.canRedo() ? "Redo " + history.redoText().toLower() : "Redo");
}

}  // namespace sinew::modeler
