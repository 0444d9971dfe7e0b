/// @file outliner.h
/// The tree of nodes in a panel, in step with the selection.
#pragma once

#include <QTreeView>

#include "panels/outliner_model.h"

namespace sinew::modeler {

class Outliner : public QTreeView {
  public:
    explicit Outliner(Model& model, QWidget* parent = nullptr);
    void rename_active();

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    void show_selection();
    void take_selection();

    Model& model_;
    OutlinerModel items_;
    bool busy_ = false;  ///< one of both selections follows the other
};

}  // namespace sinew::modeler
