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

    /// Milliseconds after which nothing more is to be hoped for: longer than sanitizers on a machine where
    /// others work need.
    static constexpr int patience = 600'000;
    /// @return true as soon as the condition holds; false when patience is over
    static bool wait(const std::function<bool()>& condition);
    /// Until the mesh shown is that of the document, and measured.
    bool wait_for_mesh();

    /// What to do once a dialog of this name is open: since a dialog waits inside the call that opened it,
    /// say it before.
    void when_dialog(const QString& name, std::function<void(QDialog&)> then);

    /// Once the file dialog of this name is open, pastes the path into it and accepts.
    void when_asked_for_file(const QString& dialog, const QString& path);
    /// Saves under a name by Ctrl+Shift+S, and opens by Ctrl+O.
    void save_as(const QString& path);
    void open(const QString& path);
    /// Drops a file on the window.
    void drop(const QString& path);
    /// Runs a command by the first letters of its name, as the command palette finds it.
    void command(const QString& name);

    /// A picture of the window in the build folder; those called guide-... are for the handbook.
    void screenshot(const std::string& name);
    static void screenshot(QWidget& widget, const std::string& name);

    /// Ends without asking.
    void close_unsaved();

  private:
    void look_at_window();

    std::unique_ptr<MainWindow> window_;
};

}  // namespace sinew::modeler
