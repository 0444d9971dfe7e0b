/// @file fake_host.h
/// A window that only says what it was asked for: for tests of actions without one.
#pragma once

#include "actions/action.h"

namespace sinew::modeler {

class FakeHost : public Host {
  public:
    std::vector<std::string> asked;

    void new_document() override { asked.push_back("new"); }
    void open() override { asked.push_back("open"); }
    bool save() override { return asked.push_back("save"), true; }
    bool save_as() override { return asked.push_back("save_as"), true; }
    void import() override { asked.push_back("import"); }
    void export_mesh() override { asked.push_back("export"); }
    void grow() override { asked.push_back("grow"); }
    void reference_pictures() override { asked.push_back("references"); }
    void quit() override { asked.push_back("quit"); }
    void start(Modal) override { asked.push_back("start"); }
    void insert_node() override { asked.push_back("insert"); }
    void rename_active() override { asked.push_back("rename"); }
    void perform(Operation operation) override { asked.push_back("perform " + operation.label); }
    void edit_radial_symmetry() override { asked.push_back("radial"); }
    void type_menu() override { asked.push_back("type_menu"); }
    void look_from(StandardView) override { asked.push_back("look"); }
    void toggle_perspective() override { asked.push_back("perspective"); }
    void frame(bool) override { asked.push_back("frame"); }
    void command_palette() override { asked.push_back("palette"); }
    void shortcut_sheet() override { asked.push_back("sheet"); }
    void about() override { asked.push_back("about"); }
    void message(const std::string&) override { asked.push_back("message"); }
};

/// Everything that an action works on.
template <class Window>
struct DeskWith {
    Model model;
    Interaction tools{model};
    ViewSettings view;
    Window host;
    Context context{model, tools, view, host};

    void run(const char* id) { find_action(id)->run(context); }
    bool enabled(const char* id) const {
        const Action& action = *find_action(id);
        return !action.enabled || action.enabled(context);
    }
    bool checked(const char* id) const { return find_action(id)->checked(context); }
};
using Desk = DeskWith<FakeHost>;

}  // namespace sinew::modeler
