/// @file settings.h
/// What is kept from one day to the next.
#pragma once

#include <string>

#include "document/view_settings.h"
#include "tools/interaction.h"

namespace sinew::modeler {

void load_view_settings(ViewSettings& view);
void save_view_settings(const ViewSettings& view);

/// What the pointer would do now, for the status line.
std::string describe_tool(const Interaction& tools);

}  // namespace sinew::modeler
