/// @file status_line.h
/// The line at the bottom: what the pointer would do, what is selected, the symmetry, the state of the mesh.
#pragma once

#include <string>

#include "document/view_settings.h"
#include "tools/interaction.h"

class QLabel;
class QStatusBar;
class QToolButton;

namespace sinew::modeler {

class ActionSet;
class MeshKeeper;

class StatusLine {
  public:
    StatusLine(QStatusBar& bar, const ActionSet& actions);
    void show(const Model& model, const Interaction& tools, const ViewSettings& view,
              const MeshKeeper& meshes);

  private:
    QLabel *hint_, *selected_, *mesh_;
    QToolButton* symmetry_;  ///< opens the choices of the menu
};

/// What a drag from where the pointer is would do; while a gesture runs, what its keys do.
std::string describe_pointer(const Interaction& tools);

}  // namespace sinew::modeler
