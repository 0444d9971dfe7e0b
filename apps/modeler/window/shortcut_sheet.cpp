#include "window/shortcut_sheet.h"

#include <QDialogButtonBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include "actions/action.h"
#include "actions/mouse.h"
#include "look/theme.h"
#include "window/action_set.h"

namespace sinew::modeler {
namespace {

QLabel* heading(const QString& text) {
    auto* label = new QLabel(text);
    label->setStyleSheet("font-weight: 700; color: #7fb2ee; padding-top: 8px;");
    return label;
}

QLabel* key_label(const QString& keys) {
    auto* label = new QLabel(keys);
    label->setStyleSheet("background: #343a44; border-radius: 4px; padding: 1px 7px; color: #e4e7ec;");
    return label;
}

void add_row(QGridLayout& grid, QWidget* left, QWidget* right) {
    const int row = grid.rowCount();
    grid.addWidget(left, row, 0, Qt::AlignLeft);
    grid.addWidget(right, row, 1, Qt::AlignRight);
}

void add_menu(QGridLayout& grid, Menu menu) {
    const std::string_view name = name_of(menu);
    grid.addWidget(heading(QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()))),
                   grid.rowCount(), 0, 1, 2);
    for (const Action& action : actions()) {
        const QString keys = ActionSet::shortcut_text(action);
        if (action.menu != menu || keys.isEmpty()) continue;
        auto* label = new QLabel(QString(action.name).section(" > ", -1));
        label->setToolTip(action.tip);
        if (QString(action.name).contains(" > ")) label->setText(QString(action.name).replace(" > ", ": "));
        add_row(grid, label, key_label(keys));
    }
}

QGridLayout* add_column(QHBoxLayout& columns) {
    auto* column = new QVBoxLayout;
    auto* grid = new QGridLayout;
    grid->setVerticalSpacing(3);
    grid->setHorizontalSpacing(14);
    column->addLayout(grid);
    column->addStretch();
    columns.addLayout(column);
    return grid;
}

}  // namespace

ShortcutSheet::ShortcutSheet(QWidget* parent) : QDialog(parent) {
    setObjectName("shortcut_sheet");
    setWindowTitle("Keys and mouse");
    auto* page = new QWidget;
    auto* columns = new QHBoxLayout(page);
    columns->setSpacing(28);
    columns->setContentsMargins(16, 4, 16, 8);
    QGridLayout* first = add_column(*columns);
    first->addWidget(heading("Mouse"), 0, 0, 1, 2);
    for (const MouseUse& use : mouse_uses()) {
        auto* how = new QLabel(use.how);
        how->setWordWrap(true);
        how->setMinimumWidth(210);
        how->setStyleSheet("color: #b9c0cb");
        const int row = first->rowCount();
        first->addWidget(new QLabel(use.what), row, 0, Qt::AlignLeft | Qt::AlignTop);
        first->addWidget(how, row, 1);
    }
    add_menu(*first, Menu::file);
    QGridLayout* second = add_column(*columns);
    for (Menu menu : {Menu::skeleton, Menu::help}) add_menu(*second, menu);
    QGridLayout* third = add_column(*columns);
    for (Menu menu : {Menu::edit, Menu::select}) add_menu(*third, menu);
    QGridLayout* fourth = add_column(*columns);
    add_menu(*fourth, Menu::view);

    auto* scroll = new QScrollArea;
    scroll->setWidget(page);
    scroll->setWidgetResizable(true);
    auto* close = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(close, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->addWidget(scroll);
    column->addWidget(close);
    const QSize wanted = page->sizeHint() + QSize(60, 90);
    resize(wanted.boundedTo(parent->size() * 0.95));
}

}  // namespace sinew::modeler
