#include "actions/enabled.h"
#include "document/edits.h"

namespace sinew::modeler {
namespace {

const std::vector<std::int32_t>& selected(const Context& c) { return c.model.selection().nodes; }

const Node* active(const Context& c) {
    const std::int32_t node = c.model.selection().active;
    return node < 0 ? nullptr : &c.model.document().nodes[node];
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
    return active(c) && active(c)->type == type;
}

bool is_rectangular(const Context& c) { return active(c) && active(c)->section == Section::rectangular; }
bool is_sharp(const Context& c) { return active(c) && active(c)->joint > 0; }

void flip_section(Context& c) {
    c.model.apply("Section", set(c.model.document(), selected(c), &Node::section,
                                 is_rectangular(c) ? Section::round : Section::rectangular));
}
void flip_joint(Context& c) {
    c.model.apply("Joint",
                  set(c.model.document(), selected(c), &Node::joint, is_sharp(c) ? 0.0 : infinitely_sharp));
}

const Action type_table[] = {
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
     any_selected, is_rectangular, false, false, true},
    {"node.joint", "Sharp joint", "J", "The ring of the node stays a sharp edge", Menu::skeleton, flip_joint,
     any_selected, is_sharp, false, false, true},
};

}  // namespace

std::span<const Action> type_actions() { return type_table; }

}  // namespace sinew::modeler
