/// @file view_bar.h
/// The right end of the toolbar: how the mesh is shown, within one click.
#pragma once

#include <functional>

#include "document/view_settings.h"

class QSlider;
class QToolBar;

namespace sinew::modeler {

class ActionSet;

class ViewBar {
  public:
    /// @param changed  called after the slider has changed the settings
    ViewBar(QToolBar& bar, ActionSet& actions, ViewSettings& view, std::function<void()> changed);
    /// The slider follows the settings.
    void refresh();

  private:
    ViewSettings& view_;
    QSlider* opacity_;
};

}  // namespace sinew::modeler
