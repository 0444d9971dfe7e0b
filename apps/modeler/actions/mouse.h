/// @file mouse.h
/// What the mouse does, for the shortcut sheet and the docs: the one thing that the table of actions does not
/// hold.
#pragma once

#include <span>
#include <string>

namespace sinew::modeler {

struct MouseUse {
    const char* what;
    const char* how;
};
std::span<const MouseUse> mouse_uses();
std::string mouse_as_markdown();

}  // namespace sinew::modeler
