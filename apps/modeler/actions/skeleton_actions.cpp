#include "actions/enabled.h"
#include "document/edits.h"

namespace sinew::modeler {
namespace {

const std::vector<std::int32_t>& selected(const Context& c) { return c.model.selection().nodes; }

template <Tool tool>
void take(Context& c) {
    c.tools.tool = tool;
}
template <Tool tool>
bool taken(const Context& c) {
    return c.tools.tool == tool;
}

template <NodeType type>
void set_type_to(Context& c) {
    const Document next = set_type(c.model.document(), selected(c), type);
    int refused = 0;
    for (std::int32_t node : selected(c)) refused += next.nodes[node].type != type;
    c.model.apply("Type", next);
    if (refused > 0) c.host.message("This type is for the ends of limbs: nodes with one bone");
}
template <NodeType type>
bool has_type(const Context& c) {
    const Selection& selection = c.model.selection();
    return selection.active >= 0 && c.model.document().nodes[selection.active].type == type;
}

void flip_section(Context& c) {
    const bool round = c.model.document().nodes[c.model.selection().active].section == Section::round;
    c.model.apply("Section", set(c.model.document(), selected(c), &Node::section,
                                 round ? Section::rectangular : Section::round));
}
void flip_joint(Context& c) {
    const bool smooth = c.model.document().nodes[c.model.selection().active].joint == 0;
    c.model.apply("Joint",
                  set(c.model.document(), selected(c), &Node::joint, smooth ? infinitely_sharp : 0.0));
}

template <int axis>
void mirror_at(Context& c) {
    Document next = c.model.document();
    const Symmetry wanted{Symmetry::Kind::mirror, axis, 1};
    next.symmetry = wanted;
    c.model.apply("Symmetry", std::move(next));
}
template <int axis>
bool mirrored_at(const Context& c) {
    const Symmetry& symmetry = c.model.document().symmetry;
    return symmetry.kind == Symmetry::Kind::mirror && symmetry.axis == axis;
}

const Action table[] = {
    {"tool.draw", "Draw", "D", "Drag from a node for a child, from a bone to insert a node", Menu::skeleton,
     take<Tool::draw>, nullptr, taken<Tool::draw>, false, true},
    {"tool.move", "Move", "V", "Drag nodes, or the arrows at the selection", Menu::skeleton, take<Tool::move>,
     nullptr, taken<Tool::move>, false, true},
    {"tool.radius", "Radius", "C", "Drag a node to make it thicker or thinner", Menu::skeleton,
     take<Tool::radius>, nullptr, taken<Tool::radius>, false, true},
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
         if (!two_selected(c)) return c.host.start(Modal::link);
         c.model.apply("Link", toggle_link(c.model.document(), selected(c)[0], selected(c)[1]));
     },
     any_selected, nullptr, false, false, true},
    {"node.root", "Add root", "Shift+A", "A new root at the origin, joined to nothing", Menu::skeleton,
     [](Context& c) {
         const Document& document = c.model.document();
         const double radius = document.nodes.empty() ? 0.5 : document.nodes.front().radius;
         Edited edit = add_root(document, Vec3::Zero(), radius);
         c.model.apply("Add root", std::move(edit.document), std::move(edit.selection));
     }},
    {"node.type_menu", "Type...", "T", "Chooses the type of the selected nodes round the pointer",
     Menu::skeleton, [](Context& c) { c.host.type_menu(); }, any_selected, nullptr, true},
    {"type.sphere", "Type > Sphere", "Ctrl+1", "Round, and blends into its bones", Menu::skeleton,
     set_type_to<NodeType::sphere>, any_selected, has_type<NodeType::sphere>, false, false, true},
    {"type.cone", "Type > Cone", "Ctrl+2", "A pointed end", Menu::skeleton, set_type_to<NodeType::cone>,
     any_selected, has_type<NodeType::cone>, false, false, true},
    {"type.hemisphere", "Type > Flat end", "Ctrl+3", "A tube that is cut off: a flat disc", Menu::skeleton,
     set_type_to<NodeType::hemisphere>, any_selected, has_type<NodeType::hemisphere>, false, false, true},
    {"type.cube", "Type > Cube", "Ctrl+4", "A box with sharp edges", Menu::skeleton,
     set_type_to<NodeType::cube>, any_selected, has_type<NodeType::cube>, false, false, true},
    {"type.negative", "Type > Negative", "Ctrl+5", "Presses a pit into its parent", Menu::skeleton,
     set_type_to<NodeType::negative>, any_selected, has_type<NodeType::negative>, false, false, true},
    {"type.ball", "Type > Ball", "Ctrl+6", "The whole ball, which tubes leave as through a wall",
     Menu::skeleton, set_type_to<NodeType::ball>, any_selected, has_type<NodeType::ball>, false, false, true},
    {"node.section", "Rectangular section", "Q", "Flat sides from node to node", Menu::skeleton, flip_section,
     any_selected,
     [](const Context& c) {
         const Selection& s = c.model.selection();
         return s.active >= 0 && c.model.document().nodes[s.active].section == Section::rectangular;
     },
     true, false, true},
    {"node.joint", "Sharp joint", "J", "The ring of the node stays a sharp edge", Menu::skeleton, flip_joint,
     any_selected,
     [](const Context& c) {
         const Selection& s = c.model.selection();
         return s.active >= 0 && c.model.document().nodes[s.active].joint > 0;
     },
     false, false, true},
    {"symmetry.none", "Symmetry > None", "", "What is drawn is all there is", Menu::skeleton,
     [](Context& c) {
         Document next = c.model.document();
         next.symmetry = {};
         c.model.apply("Symmetry", std::move(next));
     },
     nullptr, [](const Context& c) { return !symmetric(c); }, true},
    {"symmetry.x", "Symmetry > Mirror X", "", "The left side is the mirror image of the right",
     Menu::skeleton, mirror_at<0>, nullptr, mirrored_at<0>},
    {"symmetry.y", "Symmetry > Mirror Y", "", "The front is the mirror image of the back", Menu::skeleton,
     mirror_at<1>, nullptr, mirrored_at<1>},
    {"symmetry.z", "Symmetry > Mirror Z", "", "Above is the mirror image of below", Menu::skeleton,
     mirror_at<2>, nullptr, mirrored_at<2>},
    {"symmetry.radial", "Symmetry > Radial...", "", "Images all round an axis", Menu::skeleton,
     [](Context& c) { c.host.edit_radial_symmetry(); }, nullptr,
     [](const Context& c) { return c.model.document().symmetry.kind == Symmetry::Kind::radial; }},
    {"snap.grid", "Snap > Grid", "", "Ctrl snaps to the grid while one drags", Menu::skeleton,
     [](Context& c) { c.tools.snap_to = SnapTo::grid; }, nullptr,
     [](const Context& c) { return c.tools.snap_to == SnapTo::grid; }},
    {"snap.angle", "Snap > 15 degrees", "", "Ctrl snaps to angles while one drags (Ctrl+Shift always does)",
     Menu::skeleton, [](Context& c) { c.tools.snap_to = SnapTo::angle; }, nullptr,
     [](const Context& c) { return c.tools.snap_to == SnapTo::angle; }},
};

}  // namespace

std::span<const Action> skeleton_actions() { return table; }

}  // namespace sinew::modeler
