/// @file export_dialog.h
/// Writing the mesh for other programs: format, level, sides, units.
#pragma once

#include <optional>

#include "live/pipeline.h"
#include "sinew/io/mesh_formats.h"

class QString;
class QWidget;

namespace sinew::modeler {

/// Asks, makes the mesh on another thread while a bar shows how far it is, and writes it. Errors are shown.
/// @param start  the mesh options as in the viewport
/// @return the file written; empty where nothing was
QString export_mesh(QWidget* parent, const Document& document, const MeshOptions& start,
                    const QString& beside);

}  // namespace sinew::modeler
