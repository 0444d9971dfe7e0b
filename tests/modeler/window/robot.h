/// @file robot.h
/// A person at the window: mouse and keys, nothing else. Waits for what one would wait for, never for a time.
#pragma once

#include <QPoint>
#include <functional>
#include <memory>
#include <string>

#include "modeler/temporary_folder.h"
#include "sinew/base/vec.h"
#include "window/main_window.h"

class QDialog;

namespace sinew::modeler {

class Robot {
  public:
    /// A window with a file, or a new one.
    explicit Robot(const QString& path = {});
    ~Robot();

    MainWindow& window() { return *window_; }
    const Document& document() { return window_->model().document(); }
    /// Looks from the front, without perspective, a unit being 60 pixels or so.
    void look_from_front();

    /// @name In the viewport, at points of the world
    /// @{
    void click(const Vec3& at, Qt::KeyboardModifiers held = {});
    void drag(const Vec3& from, const Vec3& to, Qt::KeyboardModifiers held = {});
    void move(const Vec3& to, Qt::KeyboardModifiers held = {});
    QPoint pixel(const Vec3& at);
    /// @}

    void key(Qt::Key key, Qt::KeyboardModifiers held = {});
    void type(const QString& text);  ///< into whatever has the focus

    /// @return true as soon as the condition holds; false after a generous limit
    static bool wait(const std::function<bool()>& condition);
    /// Until the mesh shown is that of the document, and measured.
    bool wait_for_mesh();

    /// What to do once a dialog of this name is open: since a dialog waits inside the call that opened it,
    /// say it before.
    void when_dialog(const QString& name, std::function<void(QDialog&)> then);

    /// Saves under a name by Ctrl+Shift+S, and opens by Ctrl+O: the path is pasted into the dialog.
    void save_as(const QString& path);
    void open(const QString& path);

    /// A picture of the window in the build folder; those called guide-... are for the handbook.
    void screenshot(const std::string& name);
    static void screenshot(QWidget& widget, const std::string& name);

    /// Ends without asking.
    void close_unsaved();

  private:
    std::unique_ptr<MainWindow> window_;
};

}  // namespace sinew::modeler
