/// @file dialogs.h
/// Small dialogs that ask for a few values.
#pragma once

#include <optional>
#include <string>

#include "live/pipeline.h"
#include "sinew/skeleton/document.h"
#include "viewport/reference_pictures.h"

class QWidget;

namespace sinew::modeler {

/// Axis and count of a radial symmetry; nothing where the person thought better of it.
std::optional<Symmetry> ask_radial_symmetry(QWidget* parent, const Symmetry& now);

/// Pictures, their heights and opacities; `changed` is called at every change, so that one sees what one
/// does.
void ask_reference_pictures(QWidget* parent, ReferencePictures& pictures,
                            const std::function<void()>& changed);

void show_about(QWidget* parent);

}  // namespace sinew::modeler
