/// @file command_palette.h
/// Any command by a few letters.
#pragma once

#include <QFrame>

#include "actions/action.h"

class QLineEdit;
class QListWidget;

namespace sinew::modeler {

class ActionSet;

class CommandPalette : public QFrame {
  public:
    CommandPalette(ActionSet& actions, QWidget& window);
    void open();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void filter();
    void run();
    void move_by(int rows);

    ActionSet& actions_;
    QWidget& window_;
    QWidget* focus_before_ = nullptr;
    QLineEdit* text_;
    QListWidget* list_;
};

}  // namespace sinew::modeler
