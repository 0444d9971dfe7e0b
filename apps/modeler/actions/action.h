/// @file action.h
/// Everything that the modeler can do, declared once. Menus, the toolbar, the context menu, the command
/// palette, the shortcut sheet and the table of keys in the docs are made from this table.
#pragma once

#include <span>
#include <string>

#include "document/model.h"
#include "document/operation.h"
#include "document/view_settings.h"
#include "tools/interaction.h"

namespace sinew::modeler {

/// What only a window can do.
class Host {
  public:
    virtual ~Host() = default;
    virtual void new_document() = 0;
    virtual void open() = 0;
    virtual bool save() = 0;  ///< false: not saved
    virtual bool save_as() = 0;
    virtual void import() = 0;
    virtual void export_mesh() = 0;
    virtual void grow() = 0;
    virtual void reference_pictures() = 0;
    virtual void quit() = 0;
    virtual void start(Modal modal) = 0;  ///< with the pointer where it is
    virtual void insert_node() = 0;       ///< on the bone under the pointer, else on those of the selection
    virtual void rename_active() = 0;
    virtual void perform(Operation operation) = 0;  ///< at once; its figures can be adjusted afterwards
    virtual void edit_radial_symmetry() = 0;
    virtual void type_menu() = 0;  ///< at the pointer
    virtual void look_from(StandardView view) = 0;
    virtual void toggle_perspective() = 0;
    virtual void frame(bool all) = 0;
    virtual void command_palette() = 0;
    virtual void shortcut_sheet() = 0;
    virtual void about() = 0;
    virtual void message(const std::string& text) = 0;  ///< a line that goes away by itself
};

struct Context {
    Model& model;
    Interaction& tools;
    ViewSettings& view;
    Host& host;
};

enum class Menu : std::uint8_t { file, edit, select, skeleton, view, help };

struct Action {
    const char* id;        ///< never changes: settings and tests name it
    const char* name;      ///< as in the menu; "Type > Cone" is Cone in the submenu Type
    const char* shortcut;  ///< Qt's portable text; several with " | " between; "" for none
    const char* tip;       ///< what it does, a sentence without a full stop
    Menu menu;
    void (*run)(Context&);
    bool (*enabled)(const Context&) = nullptr;  ///< null: always
    bool (*checked)(const Context&) = nullptr;  ///< null: nothing to be checked
    bool separated = false;                     ///< a line above it in its menu
    bool in_toolbar = false;
    bool in_context_menu = false;
};

/// All of them, menu by menu, in the order of the menus.
std::span<const Action> actions();
/// Null where there is none.
const Action* find_action(std::string_view id);
std::string_view name_of(Menu menu);

/// The actions whose name, submenu or tip contain the letters of `text` in order, best first; all for no
/// text.
std::vector<const Action*> search_actions(std::string_view text);

/// The table of keys for the docs, in Markdown.
std::string keys_as_markdown();

// The parts of the table, in the order of the menus.
std::span<const Action> file_actions();
std::span<const Action> edit_actions();
std::span<const Action> select_actions();
std::span<const Action> drawing_actions();
std::span<const Action> operation_actions();
std::span<const Action> type_actions();
std::span<const Action> symmetry_actions();
std::span<const Action> view_actions();
std::span<const Action> help_actions();

}  // namespace sinew::modeler
