/// @file main_window.h
/// Puts the parts together: viewport, panels, menus, files. What each does it does itself.
#pragma once

#include <QTimer>
#include <memory>

#include "actions/action.h"
#include "document/model.h"
#include "document/view_settings.h"
#include "tools/interaction.h"
#include "window/file_keeper.h"
#include "window/mesh_keeper.h"
#include "window/window_parts.h"

namespace sinew::modeler {

class ActionSet;
class CommandPalette;
class Outliner;
class Problems;
class Statistics;
class StatusLine;
class ViewBar;
class Viewport;
class WindowHost;

class MainWindow : public WindowParts {
  public:
    MainWindow();
    ~MainWindow() override;

    /// Opens a file, or starts anew where there is none.
    void start(const QString& path);

    void put_over_properties(QDockWidget& panel) override;
    void lock(bool locked) override;

    Model& model() override { return model_; }
    Interaction& tools() override { return tools_; }
    ViewSettings& view() override { return view_; }
    Viewport& viewport() override { return *viewport_; }
    FileKeeper& files() override { return files_; }
    MeshKeeper& meshes() override { return *meshes_; }
    ActionSet& actions() { return *action_set_; }

  protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    void make_panels();
    void make_bars();
    void connect_parts();
    QDockWidget* add_panel(const QString& title, QWidget* widget, Qt::DockWidgetArea area);
    void open_dropped(const QString& path);
    void show_mesh(const std::shared_ptr<const LiveMesh>& mesh);
    void refresh();  ///< after an action or a gesture: what is enabled, what the lines say
    void refresh_title();
    void refresh_recent();
    void keep_copy();
    void load_settings();
    void save_settings();

    Model model_;
    Interaction tools_{model_};
    ViewSettings view_;
    Viewport* viewport_;
    FileKeeper files_;
    Recovery recovery_;
    std::unique_ptr<WindowHost> host_;
    std::unique_ptr<Context> context_;
    std::unique_ptr<ActionSet> action_set_;
    std::unique_ptr<MeshKeeper> meshes_;
    std::unique_ptr<ViewBar> view_bar_;
    std::unique_ptr<StatusLine> status_;
    CommandPalette* palette_ = nullptr;
    Outliner* outliner_ = nullptr;
    Statistics* statistics_ = nullptr;
    Problems* problems_ = nullptr;
    QList<QDockWidget*> panels_;
    QDockWidget* problems_dock_ = nullptr;
    QMenu* recent_ = nullptr;
    QTimer copy_timer_;  ///< from a change to the copy that would survive a crash
};

/// Where copies for the case of a crash are kept.
std::filesystem::path recovery_folder();

}  // namespace sinew::modeler
