#include "actions/enabled.h"
#include "document/edits.h"

namespace sinew::modeler {
namespace {

void apply(Context& c, const char* label, Edited edit) {
    c.model.apply(label, std::move(edit.document), std::move(edit.selection));
}

const Action edit_table[] = {
    {"edit.undo", "Undo", "Ctrl+Z", "Takes the last step back", Menu::edit,
     [](Context& c) { c.model.undo(); },
     [](const Context& c) { return c.model.history().canUndo() || c.model.previewing(); }, nullptr, false,
     true},
    {"edit.redo", "Redo", "Ctrl+Shift+Z | Ctrl+Y", "Does again what was taken back", Menu::edit,
     [](Context& c) { c.model.redo(); }, [](const Context& c) { return c.model.history().canRedo(); },
     nullptr, false, true},
    {"edit.duplicate", "Duplicate", "Ctrl+D",
     "Copies the selected nodes with their bones; the copy follows the pointer", Menu::edit,
     [](Context& c) { c.host.start(Modal::duplicate); }, any_selected, nullptr, true, false, true},
    {"edit.delete", "Delete", "X | Del", "Takes the selected nodes out; their limbs stay attached",
     Menu::edit, [](Context& c) { apply(c, "Delete", erase_nodes(c.model.document(), c.model.selection())); },
     any_selected, nullptr, false, false, true},
    {"edit.delete_branch", "Delete branch", "Shift+X | Shift+Del",
     "Takes the selected nodes out, and all below them", Menu::edit,
     [](Context& c) { apply(c, "Delete branch", erase_branches(c.model.document(), c.model.selection())); },
     any_selected},
    {"edit.rename", "Rename", "F2", "Gives the active node a name", Menu::edit,
     [](Context& c) { c.host.rename_active(); }, any_selected, nullptr, true},
};

}  // namespace

std::span<const Action> edit_actions() { return edit_table; }

}  // namespace sinew::modeler
