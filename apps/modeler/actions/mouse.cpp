#include "actions/mouse.h"

#include <fmt/format.h>

namespace sinew::modeler {
namespace {

const MouseUse mouse_table[] = {
    {"Draw a child", "Draw tool: drag from a node"},
    {"Insert a node", "Draw tool: drag from a bone"},
    {"Move", "Move tool, or Shift: drag a node or a bone"},
    {"Change the radius", "Ctrl-drag a node, or the wheel over it"},
    {"Snap", "Ctrl while dragging: other nodes, mirror, grid or angle; Ctrl+Shift: 15 degrees"},
    {"Hold an axis", "X, Y, Z while dragging; with Shift: the plane across it"},
    {"Type an exact amount", "Figures while dragging, then Enter"},
    {"Select", "Click; Shift adds; drag from nothing: a box"},
    {"Select what is hidden", "Click again at the same place"},
    {"Stop a gesture", "Esc or right button"},
    {"Commands for what is under the pointer", "Right click"},
    {"Orbit", "Middle or right button, or Alt and left"},
    {"Pan", "The same with Shift"},
    {"Zoom", "Wheel, or the same with Ctrl"},
};

}  // namespace

std::span<const MouseUse> mouse_uses() { return mouse_table; }

std::string mouse_as_markdown() {
    std::string text = "| To | Do |\n|---|---|\n";
    for (const MouseUse& use : mouse_table) text += fmt::format("| {} | {} |\n", use.what, use.how);
    return text;
}

}  // namespace sinew::modeler
