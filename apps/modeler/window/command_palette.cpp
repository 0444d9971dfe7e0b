#include "window/command_palette.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include "look/icons.h"
#include "look/theme.h"
#include "window/action_set.h"

namespace sinew::modeler {
namespace {

constexpr int sheet_width = 520, most_rows = 11, row_height = 30;
constexpr int action_role = Qt::UserRole;

const Action& action_of(const QListWidgetItem& item) {
    return *static_cast<const Action*>(item.data(action_role).value<void*>());
}

/// Name at the left, menu in grey, keys at the right.
class Row : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;
    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override {
        return {sheet_width - 20, row_height};
    }
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        const Action& action = *static_cast<const Action*>(index.data(action_role).value<void*>());
        const bool enabled = index.flags().testFlag(Qt::ItemIsEnabled);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        if (option.state & QStyle::State_Selected) {
            painter->setPen(Qt::NoPen);
            painter->setBrush(QColor(0x34, 0x55, 0x7f));
            painter->drawRoundedRect(option.rect.adjusted(2, 1, -2, -1), 5, 5);
        }
        icon(action.id).paint(painter, QRect(option.rect.left() + 10, option.rect.top() + 6, 18, 18),
                              Qt::AlignCenter, enabled ? QIcon::Normal : QIcon::Disabled);
        const QRect text = option.rect.adjusted(38, 0, -14, 0);
        const QString name = action.name;
        painter->setPen(enabled ? theme::text : QColor(0x6a, 0x71, 0x7c));
        painter->drawText(text, Qt::AlignVCenter | Qt::AlignLeft, name);
        const std::string_view menu = name_of(action.menu);
        painter->setPen(theme::dim_text);
        painter->drawText(text.adjusted(option.fontMetrics.horizontalAdvance(name) + 12, 0, 0, 0),
                          Qt::AlignVCenter | Qt::AlignLeft,
                          QString::fromUtf8(menu.data(), static_cast<qsizetype>(menu.size())));
        painter->drawText(text, Qt::AlignVCenter | Qt::AlignRight, ActionSet::shortcut_text(action));
        painter->restore();
    }
};

}  // namespace

CommandPalette::CommandPalette(ActionSet& actions, QWidget& window)
    : QFrame(&window), actions_(actions), window_(window) {
    setObjectName("command_palette");
    setStyleSheet(
        "#command_palette { background: #23262c; border: 1px solid #4f8fdc; border-radius: 8px; }"
        "QListWidget { background: transparent; }");
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 10, 10, 10);
    column->setSpacing(8);
    text_ = new QLineEdit;
    text_->setObjectName("command_palette_text");
    text_->setPlaceholderText("What do you want to do?");
    text_->setMinimumHeight(30);
    list_ = new QListWidget;
    list_->setObjectName("command_palette_list");
    list_->setItemDelegate(new Row(list_));
    list_->setFocusPolicy(Qt::NoFocus);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setMouseTracking(true);
    column->addWidget(text_);
    column->addWidget(list_);
    text_->installEventFilter(this);
    connect(text_, &QLineEdit::textChanged, this, [this] { filter(); });
    connect(list_, &QListWidget::itemClicked, this, [this] { run(); });
    hide();
}

void CommandPalette::open() {
    focus_before_ = QApplication::focusWidget();
    actions_.refresh();
    text_->clear();
    filter();
    move((window_.width() - sheet_width) / 2, std::max(40, window_.height() / 8));
    show();
    raise();
    text_->setFocus();
}

void CommandPalette::filter() {
    list_->clear();
    for (const Action* action : search_actions(text_->text().toStdString())) {
        if (std::string_view(action->id) == "help.palette") continue;
        auto* item = new QListWidgetItem(list_);
        item->setData(action_role, QVariant::fromValue(static_cast<void*>(const_cast<Action*>(action))));
        if (!actions_.find(action->id)->isEnabled()) item->setFlags(item->flags() & ~Qt::ItemIsEnabled);
    }
    list_->setCurrentRow(0);
    resize(sheet_width, std::min(list_->count(), most_rows) * row_height + 68);
}

void CommandPalette::run() {
    const QListWidgetItem* item = list_->currentItem();
    if (!item || !item->flags().testFlag(Qt::ItemIsEnabled)) return;
    const Action& action = action_of(*item);
    hide();
    if (focus_before_) focus_before_->setFocus();
    actions_.run(action);
}

void CommandPalette::move_by(int rows) {
    const int count = list_->count();
    if (count > 0) list_->setCurrentRow((list_->currentRow() + rows + count) % count);
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusOut) hide();
    if (event->type() != QEvent::KeyPress) return QFrame::eventFilter(watched, event);
    switch (static_cast<QKeyEvent*>(event)->key()) {
        case Qt::Key_Down:
            move_by(1);
            return true;
        case Qt::Key_Up:
            move_by(-1);
            return true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            run();
            return true;
        case Qt::Key_Escape:
            hide();
            if (focus_before_) focus_before_->setFocus();
            return true;
        default:
            return QFrame::eventFilter(watched, event);
    }
}

}  // namespace sinew::modeler
