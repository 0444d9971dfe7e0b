#include "look/theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>

namespace sinew::modeler::theme {
namespace {

QPalette palette() {
    QPalette p;
    p.setColor(QPalette::Window, window);
    p.setColor(QPalette::WindowText, text);
    p.setColor(QPalette::Base, field);
    p.setColor(QPalette::AlternateBase, panel);
    p.setColor(QPalette::Text, text);
    p.setColor(QPalette::Button, QColor(0x38, 0x3d, 0x47));
    p.setColor(QPalette::ButtonText, text);
    p.setColor(QPalette::BrightText, Qt::white);
    p.setColor(QPalette::ToolTipBase, QColor(0x14, 0x16, 0x1a));
    p.setColor(QPalette::ToolTipText, text);
    p.setColor(QPalette::Highlight, accent);
    p.setColor(QPalette::HighlightedText, Qt::white);
    p.setColor(QPalette::Link, accent.lighter(120));
    p.setColor(QPalette::PlaceholderText, QColor(0x78, 0x80, 0x8c));
    p.setColor(QPalette::Light, QColor(0x48, 0x4e, 0x5a));
    p.setColor(QPalette::Midlight, QColor(0x40, 0x45, 0x50));
    p.setColor(QPalette::Mid, border);
    p.setColor(QPalette::Dark, QColor(0x1a, 0x1c, 0x20));
    p.setColor(QPalette::Shadow, QColor(0x10, 0x11, 0x14));
    const QColor off(0x6a, 0x71, 0x7c);
    for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        p.setColor(QPalette::Disabled, role, off);
    p.setColor(QPalette::Disabled, QPalette::Highlight, border);
    return p;
}

const char* const sheet = R"(
QToolTip { color: #e4e7ec; background: #14161a; border: 1px solid #3b404a; padding: 4px 6px; }
QMainWindow::separator { background: #1b1d22; width: 4px; height: 4px; }
QMainWindow::separator:hover { background: #4f8fdc; }
QMenuBar { background: #2b2e35; padding: 2px 4px; }
QMenuBar::item { padding: 4px 9px; border-radius: 4px; background: transparent; }
QMenuBar::item:selected { background: #3f4550; }
QMenu { background: #23262c; border: 1px solid #3b404a; padding: 5px; }
QMenu::item { padding: 5px 28px 5px 10px; border-radius: 4px; }
QMenu::icon { padding-left: 6px; }
QMenu::item:selected { background: #3d6fae; color: white; }
QMenu::item:disabled { color: #6a717c; background: transparent; }
QMenu::separator { height: 1px; background: #3b404a; margin: 5px 8px; }
QMenu::indicator { width: 14px; height: 14px; margin-left: 6px; }
QMenu::indicator:checked { image: url(:/icons/tick.svg); }
QToolBar { background: #2b2e35; border: none; border-bottom: 1px solid #1b1d22; spacing: 3px; padding: 4px 6px; }
QToolBar::separator { background: #3b404a; width: 1px; margin: 4px 5px; }
QToolButton { border: 1px solid transparent; border-radius: 5px; padding: 4px; }
QToolButton[narrow="true"] { padding: 4px 0px; }
QToolButton:hover { background: #3a3f49; }
QToolButton:pressed { background: #1f2228; }
QToolButton:checked { background: #2f4f78; border-color: #4f8fdc; }
QDockWidget { font-weight: 600; titlebar-close-icon: url(:/icons/dock.close.svg); titlebar-normal-icon: url(:/icons/dock.float.svg); }
QDockWidget::title { background: #2b2e35; padding: 7px 10px; border-top: 1px solid #1b1d22; }
QDockWidget::close-button, QDockWidget::float-button { background: transparent; border: none; border-radius: 3px; padding: 1px; icon-size: 14px; }
QDockWidget::close-button:hover, QDockWidget::float-button:hover { background: #434955; }
QTabBar::tab { background: #23262c; color: #98a0ad; padding: 6px 12px; border: none; border-top: 2px solid transparent; }
QTabBar::tab:selected { background: #2b2e35; color: #e4e7ec; border-top-color: #4f8fdc; }
QTabBar::tab:hover { color: #e4e7ec; }
QTreeView, QListView, QTableView { background: #1f2227; border: none; outline: 0; show-decoration-selected: 1; }
QTreeView::item, QListView::item { padding: 3px 2px; border: none; }
QTreeView::item:hover, QListView::item:hover { background: #2c3038; }
QTreeView::item:selected, QListView::item:selected { background: #34557f; color: white; }
QTreeView::branch:selected { background: #34557f; }
QTreeView::branch:hover:!selected { background: #2c3038; }
QTreeView::branch:has-children:closed { image: url(:/icons/arrow.right.svg); }
QTreeView::branch:has-children:open { image: url(:/icons/arrow.down.svg); }
QHeaderView::section { background: #23262c; color: #98a0ad; border: none; padding: 4px 6px; }
QLineEdit, QDoubleSpinBox, QSpinBox, QComboBox, QPlainTextEdit {
    background: #1b1d22; border: 1px solid #3b404a; border-radius: 4px; padding: 3px 6px; min-height: 18px;
    selection-background-color: #3d6fae; }
QLineEdit:focus, QDoubleSpinBox:focus, QSpinBox:focus, QComboBox:focus, QPlainTextEdit:focus { border-color: #4f8fdc; }
QLineEdit:disabled, QDoubleSpinBox:disabled, QSpinBox:disabled, QComboBox:disabled { color: #5d636d; border-color: #2f333b; }
QDoubleSpinBox, QSpinBox { padding-right: 16px; }
QAbstractSpinBox::up-button, QAbstractSpinBox::down-button { width: 14px; border: none; background: transparent; }
QAbstractSpinBox::up-button:hover, QAbstractSpinBox::down-button:hover { background: #343943; }
QAbstractSpinBox::up-arrow { image: url(:/icons/arrow.up.svg); width: 11px; height: 11px; }
QAbstractSpinBox::down-arrow { image: url(:/icons/arrow.down.svg); width: 11px; height: 11px; }
QComboBox::drop-down { border: none; width: 20px; }
QComboBox::down-arrow { image: url(:/icons/arrow.down.svg); width: 13px; height: 13px; }
QComboBox QAbstractItemView { background: #23262c; border: 1px solid #3b404a; padding: 4px; }
QPushButton { background: #383d47; border: 1px solid #474d59; border-radius: 5px; padding: 5px 14px; min-height: 18px; }
QPushButton:hover { background: #434955; }
QPushButton:pressed { background: #2c3038; }
QPushButton:default { background: #3d6fae; border-color: #4f8fdc; color: white; }
QPushButton:default:hover { background: #467dc2; }
QPushButton:disabled { color: #6a717c; background: #2c3037; border-color: #343943; }
QScrollBar:vertical { background: transparent; width: 10px; margin: 0; }
QScrollBar:horizontal { background: transparent; height: 10px; margin: 0; }
QScrollBar::handle { background: #434955; border-radius: 4px; min-height: 24px; min-width: 24px; margin: 1px; }
QScrollBar::handle:hover { background: #566070; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QScrollArea { border: none; background: transparent; }
QStatusBar { background: #23262c; color: #98a0ad; }
QStatusBar::item { border: none; }
QStatusBar QLabel { padding: 1px 8px; }
QStatusBar QToolButton { color: #98a0ad; padding: 1px 8px; }
QStatusBar QToolButton::menu-indicator { image: none; }
QSlider::groove:horizontal { height: 4px; background: #1b1d22; border-radius: 2px; }
QSlider::sub-page:horizontal { background: #4f8fdc; border-radius: 2px; }
QSlider::handle:horizontal { background: #cfd5de; width: 12px; margin: -4px 0; border-radius: 6px; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
QLabel[dim="true"] { color: #98a0ad; }
QFrame#adjust_panel { background: rgba(24, 26, 31, 235); border: 1px solid #3b404a; border-radius: 8px; }
QCheckBox::indicator { width: 15px; height: 15px; border: 1px solid #4a505c; border-radius: 3px; background: #1b1d22; }
QCheckBox::indicator:checked { background: #3d6fae; border-color: #4f8fdc; image: url(:/icons/tick.svg); }
)";

}  // namespace

void apply(QApplication& application) {
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    QApplication::setPalette(palette());
    application.setStyleSheet(sheet);
}

}  // namespace sinew::modeler::theme
