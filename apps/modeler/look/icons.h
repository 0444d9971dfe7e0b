/// @file icons.h
/// The program's own icons, drawn from SVG at whatever size and density is asked for.
#pragma once

#include <QIcon>

#include "sinew/skeleton/document.h"

namespace sinew::modeler {

/// The icon called `name` (that of an action is its id); an empty one where there is none.
QIcon icon(const QString& name);

/// That of a node: its type, red for a root.
QIcon icon_of(const Node& node);

}  // namespace sinew::modeler
