/// @file settings.h
/// What is kept from one day to the next.
#pragma once

#include "document/view_settings.h"

namespace sinew::modeler {

void load_view_settings(ViewSettings& view);
void save_view_settings(const ViewSettings& view);

}  // namespace sinew::modeler
