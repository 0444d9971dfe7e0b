/// @file adjust_panel.h
/// The figures of what one has just done, in a corner of the viewport: changing them changes that step.
#pragma once

#include <QFrame>
#include <functional>

#include "document/model.h"
#include "document/operation.h"

class QFormLayout;
class QLabel;

namespace sinew::modeler {

/// Goes away with the next edit or selection, and with Enter or Escape.
class AdjustPanel : public QFrame {
  public:
    /// @param say  a line for the person
    AdjustPanel(Model& model, QWidget& viewport, std::function<void(const std::string&)> say);

    /// One undo step, whatever is adjusted afterwards.
    void perform(Operation operation);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void apply();
    void make_fields();
    QWidget* make_field(std::size_t i);
    void place();
    void leave();

    Model& model_;
    QWidget& viewport_;
    std::function<void(const std::string&)> say_;
    Operation operation_;
    std::vector<double> values_;
    Document before_;
    Selection selection_before_;
    Model::MergeKey key_ = 1000;  ///< another one for each operation, so that two of a kind stay two steps
    bool busy_ = false;
    QLabel* title_;
    QFormLayout* form_;
};

}  // namespace sinew::modeler
