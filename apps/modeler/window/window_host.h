/// @file window_host.h
/// What actions ask of the window.
#pragma once

#include <QPointer>

#include "actions/action.h"

namespace sinew::modeler {

class AdjustPanel;
class GrowPanel;
class TypeMenu;
class WindowParts;

class WindowHost : public Host {
  public:
    explicit WindowHost(WindowParts& window);

    void new_document() override;
    void open() override;
    bool save() override;
    bool save_as() override;
    void import() override;
    void export_mesh() override;
    void grow() override;
    void reference_pictures() override;
    void quit() override;
    void start(Modal modal) override;
    void insert_node() override;
    void rename_active() override;
    void perform(Operation operation) override;
    void edit_radial_symmetry() override;
    void type_menu() override;
    void look_from(StandardView view) override;
    void toggle_perspective() override;
    void frame(bool all) override;
    void command_palette() override;
    void shortcut_sheet() override;
    void about() override;
    void message(const std::string& text) override;

    void grow_file(const QString& path);
    /// Puts a picture behind the view along an axis that one has, else behind the one from the front.
    void draw_after(const QString& picture);
    void stop_growing();

    std::function<void()> palette_wanted, rename_wanted;

  private:
    QString ask_grammar();

    WindowParts& window_;
    TypeMenu* type_menu_ = nullptr;
    AdjustPanel* adjust_panel_ = nullptr;
    QPointer<GrowPanel> growing_;
};

}  // namespace sinew::modeler
