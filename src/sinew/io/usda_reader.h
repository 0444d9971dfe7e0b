/// @file usda_reader.h
/// Meshes from USD text files.
#pragma once

#include <string>
#include <string_view>

#include "sinew/base/result.h"
#include "sinew/mesh/quad_mesh.h"

namespace sinew {

/// Reads all Mesh prims of a .usda file, one after the other, placed by their transforms and turned so that z
/// is up: points (the first of time samples), faces, creases and corners (those of sharpness 10 and above;
/// our corners know no less). Variants, classes, inactive prims, references and payloads are not followed.
/// Fails, with line and column, for what is no USD text, for faces that name no vertex or have fewer than
/// three corners, for what is not finite, and where there is no mesh.
/// @param name  of the file, for messages
Result<QuadMesh> parse_usda(std::string_view text, const std::string& name);

}  // namespace sinew
