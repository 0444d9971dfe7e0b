#include "actions/choices.h"
#include "actions/enabled.h"
#include "document/edits.h"
#include "document/operation.h"

namespace sinew::modeler {
namespace {

/// What one drags, and what keys begin at the selection.
const Action drawing[] = {
    {"tool.draw", "Draw", "D", "Drag from a node for a child, from a bone to insert a node", Menu::skeleton,
     choose<&Interaction::tool, Tool::draw>, nullptr, is_chosen<&Interaction::tool, Tool::draw>, false, true},
    {"tool.move", "Move", "V", "Drag nodes, or the arrows at the selection", Menu::skeleton,
     choose<&Interaction::tool, Tool::move>, nullptr, is_chosen<&Interaction::tool, Tool::move>, false, true},
    {"tool.radius", "Radius", "C", "Drag a node to make it thicker or thinner", Menu::skeleton,
     choose<&Interaction::tool, Tool::radius>, nullptr, is_chosen<&Interaction::tool, Tool::radius>, false,
     true},
    {"node.extrude", "Extrude", "E",
     "Draws a child of each selected node; it follows the pointer until you click", Menu::skeleton,
     [](Context& c) { c.host.start(Modal::extrude); }, any_selected, nullptr, true, false, true},
    {"node.grab", "Grab", "G",
     "The selection follows the pointer until you click; X, Y, Z hold an axis, figures are exact",
     Menu::skeleton, [](Context& c) { c.host.start(Modal::move); }, any_selected},
    {"node.scale", "Scale radius", "S", "The radius follows the pointer until you click", Menu::skeleton,
     [](Context& c) { c.host.start(Modal::radius); }, any_selected},
    {"node.insert", "Insert node", "B",
     "A node on the bone under the pointer, or on the bones of the selection", Menu::skeleton,
     [](Context& c) { c.host.insert_node(); }, any_node, nullptr, false, false, true},
    {"node.link", "Link", "L", "Joins two nodes by a bone, which may close a cycle; again: parts them",
     Menu::skeleton,
     [](Context& c) {
         const std::vector<std::int32_t>& nodes = c.model.selection().nodes;
         if (!two_selected(c)) return c.host.start(Modal::link);
         c.model.apply("Link", toggle_link(c.model.document(), nodes[0], nodes[1]));
     },
     any_selected, nullptr, false, false, true},
    {"node.root", "Add root", "Shift+A", "A new root at the origin, joined to nothing", Menu::skeleton,
     [](Context& c) {
         const Document& document = c.model.document();
         const double radius = document.nodes.empty() ? 0.5 : document.nodes.front().radius;
         Edited edit = add_root(document, Vec3::Zero(), radius);
         c.model.apply("Add root", std::move(edit.document), std::move(edit.selection));
     }},
};

/// Operations of the library; their figures can be adjusted afterwards.
const Action operations[] = {
    {"node.reroot", "Re-root", "R", "Makes the active node the root of its tree", Menu::skeleton,
     [](Context& c) { c.host.perform(rerooting(c.model.document(), c.model.selection().active)); },
     any_selected, nullptr, true, false, true},
    {"node.merge", "Merge", "M",
     "The selected nodes become one; with one or none selected, leaves that are close", Menu::skeleton,
     [](Context& c) {
         const Document& document = c.model.document();
         c.host.perform(several_selected(c) ? merging(document, c.model.selection())
                                            : merging_close_leaves(document));
     },
     any_node, nullptr, false, false, true},
    {"node.consolidate", "Consolidate leaves", "Shift+C",
     "A node near each selected leaf (near all where none is), so that tips are blunter", Menu::skeleton,
     [](Context& c) { c.host.perform(consolidating(c.model.document(), c.model.selection())); }, any_node},
    {"snap.nodes_to_grid", "Snap selection > To grid", "Shift+G",
     "Moves the selected nodes (all where none is) onto a grid", Menu::skeleton,
     [](Context& c) { c.host.perform(snapping_to_grid(c.model.document(), c.model.selection())); }, any_node},
    {"snap.bones_to_angles", "Snap selection > To angles", "Shift+R",
     "Turns the bones to the selected nodes (to all where none is) to round angles", Menu::skeleton,
     [](Context& c) { c.host.perform(snapping_to_angles(c.model.document(), c.model.selection())); },
     any_node},
};

}  // namespace

std::span<const Action> drawing_actions() { return drawing; }
std::span<const Action> operation_actions() { return operations; }

}  // namespace sinew::modeler
