#include "actions/enabled.h"

namespace sinew::modeler {
namespace {

const Action file_table[] = {
    {"file.new", "New", "Ctrl+N", "Starts a new skeleton: a root at the origin, mirrored", Menu::file,
     [](Context& c) { c.host.new_document(); }},
    {"file.open", "Open...", "Ctrl+O", "Opens a skeleton in any format that is read", Menu::file,
     [](Context& c) { c.host.open(); }},
    {"file.save", "Save", "Ctrl+S", "Saves the skeleton", Menu::file, [](Context& c) { c.host.save(); },
     [](const Context& c) { return c.model.modified(); }, nullptr, true, true},
    {"file.save_as", "Save as...", "Ctrl+Shift+S", "Saves the skeleton under another name", Menu::file,
     [](Context& c) { c.host.save_as(); }},
    {"file.import", "Import...", "Ctrl+I",
     "Adds the skeleton of another file to this one: .swc, .graph, joints of glTF, .sinew", Menu::file,
     [](Context& c) { c.host.import(); }, nullptr, nullptr, true},
    {"file.grow", "Grow from L-system...", "Ctrl+G",
     "A skeleton from a .lsys file; its figures can be turned while one sees it", Menu::file,
     [](Context& c) { c.host.grow(); }},
    {"file.export", "Export mesh...", "Ctrl+E", "Writes the mesh for other programs", Menu::file,
     [](Context& c) { c.host.export_mesh(); }, any_node, nullptr, false, true},
    {"file.references", "Reference pictures...", "",
     "Pictures behind the views from the front, the side and above", Menu::file,
     [](Context& c) { c.host.reference_pictures(); }, nullptr, nullptr, true},
    {"file.quit", "Quit", "Ctrl+Q", "Closes the window; asks first where something is not saved", Menu::file,
     [](Context& c) { c.host.quit(); }, nullptr, nullptr, true},
};

}  // namespace

std::span<const Action> file_actions() { return file_table; }

}  // namespace sinew::modeler
