/// @file dialogs.h
/// Small dialogs that ask for a few values.
#pragma once

#include <optional>

#include "sinew/skeleton/document.h"

class QWidget;

namespace sinew::modeler {

/// Axis and count of a radial symmetry; nothing where the person thought better of it.
std::optional<Symmetry> ask_radial_symmetry(QWidget* parent, const Symmetry& now);

void show_about(QWidget* parent);

}  // namespace sinew::modeler
