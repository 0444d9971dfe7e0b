/// @file statistics.h
/// Figures of the skeleton and of the mesh that is shown.
#pragma once

#include <QWidget>
#include <memory>

#include "document/model.h"
#include "live/pipeline.h"

class QLabel;
class QFormLayout;

namespace sinew::modeler {

class Statistics : public QWidget {
  public:
    explicit Statistics(Model& model, QWidget* parent = nullptr);
    void show_mesh(const std::shared_ptr<const LiveMesh>& mesh);

  private:
    QLabel* add(QFormLayout& form, const char* name, const char* label);
    void refresh_skeleton();

    Model& model_;
    QLabel *nodes_, *bones_, *parts_, *vertices_, *quads_, *triangles_, *irregular_, *closed_, *time_;
};

}  // namespace sinew::modeler
