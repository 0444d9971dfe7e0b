/// @file window_parts.h
/// What the main window has and can do, for those that work on it without knowing the rest of it.
#pragma once

#include <QMainWindow>

class QDockWidget;

namespace sinew::modeler {

class FileKeeper;
class Interaction;
class MeshKeeper;
class Model;
class Viewport;
struct ViewSettings;

class WindowParts : public QMainWindow {
  public:
    virtual Model& model() = 0;
    virtual Interaction& tools() = 0;
    virtual ViewSettings& view() = 0;
    virtual Viewport& viewport() = 0;
    virtual FileKeeper& files() = 0;
    virtual MeshKeeper& meshes() = 0;

    /// Docks a panel where the properties are, which rest behind it.
    virtual void put_over_properties(QDockWidget& panel) = 0;

    /// While something else previews in the model only the view can be changed.
    virtual void lock(bool locked) = 0;
};

}  // namespace sinew::modeler
