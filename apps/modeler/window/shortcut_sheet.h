/// @file shortcut_sheet.h
/// All keys and what the mouse does, on one sheet, made from the table of actions.
#pragma once

#include <QDialog>

namespace sinew::modeler {

class ShortcutSheet : public QDialog {
  public:
    explicit ShortcutSheet(QWidget* parent);
};

}  // namespace sinew::modeler
