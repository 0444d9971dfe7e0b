/// @file obj.h
/// Wavefront OBJ: polygons as they are, positions and faces only.
#pragma once

#include <string>
#include <string_view>

#include "sinew/base/result.h"
#include "sinew/mesh/quad_mesh.h"

namespace sinew {

/// Reads the `v` and `f` lines; texture coordinates, normals, groups, materials, curves and the like are
/// passed over. Faces may name vertices as v, v/t, v//n or v/t/n, from the front or (negative) from the back,
/// also ones that come later in the file. Lines end in LF, CRLF or CR, and go on where they end in a
/// backslash. Fails, with the line, for what is no number, not finite or no vertex, for faces of fewer than
/// three corners, and where there is no face at all.
/// @param name  of the file, for messages
Result<QuadMesh> parse_obj(std::string_view text, const std::string& name);

/// The mesh as text: `v` lines in the shortest form that reads back to the same floats, then `f` lines.
/// The mesh must be well formed (topology.h).
std::string obj_text(const QuadMesh& mesh);

}  // namespace sinew
