#include "actions/enabled.h"

namespace sinew::modeler {
namespace {

template <Step step>
void walk(Context& c) {
    c.model.select(stepped(c.model.document(), c.model.selection(), step));
}

const Action select_table[] = {
    {"select.all", "All", "Ctrl+A", "Selects every node", Menu::select,
     [](Context& c) { c.model.select(all_nodes(c.model.document())); }, any_node},
    {"select.none", "Nothing", "Ctrl+Shift+A", "Selects nothing", Menu::select,
     [](Context& c) { c.model.select({}); }, any_selected},
    {"select.invert", "Invert", "I", "Selects what is not selected", Menu::select,
     [](Context& c) { c.model.select(inverted(c.model.document(), c.model.selection())); }, any_node},
    {"select.linked", "Linked", "Ctrl+L", "Selects all that bones join to the selection", Menu::select,
     [](Context& c) { c.model.select(linked(c.model.document(), c.model.selection())); }, any_selected,
     nullptr, false, false, true},
    {"select.branch", "Branch", "Ctrl+B", "Selects all below the selection", Menu::select,
     [](Context& c) { c.model.select(with_descendants(c.model.document(), c.model.selection())); },
     any_selected},
    {"select.parent", "Parent", "PgUp", "Goes one node towards the root", Menu::select, walk<Step::parent>,
     any_node, nullptr, true},
    {"select.child", "Child", "PgDown", "Goes one node towards the tips", Menu::select, walk<Step::child>,
     any_node},
    {"select.sibling", "Sibling", "End", "Goes to the next child of the same parent, round and round",
     Menu::select, walk<Step::sibling>, any_node},
};

}  // namespace

std::span<const Action> select_actions() { return select_table; }

}  // namespace sinew::modeler
