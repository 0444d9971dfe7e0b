#include "actions/action.h"

namespace sinew::modeler {
namespace {

const Action help_table[] = {
    {"help.palette", "Command palette", "Ctrl+K | F3", "Finds any command by a few letters", Menu::help,
     [](Context& c) { c.host.command_palette(); }},
    {"help.keys", "Keys and mouse", "F1", "Shows all shortcuts and what the mouse does", Menu::help,
     [](Context& c) { c.host.shortcut_sheet(); }},
    {"help.about", "About", "", "Version and licence", Menu::help, [](Context& c) { c.host.about(); }},
};

}  // namespace

std::span<const Action> help_actions() { return help_table; }

}  // namespace sinew::modeler
