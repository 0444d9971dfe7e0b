/// @file usda_writer.h
/// USD as text: polygons, the subdivision scheme and the creases.
#pragma once

#include <string>

#include "sinew/mesh/quad_mesh.h"

namespace sinew {

/// The mesh as a .usda file with one Mesh prim, z up: points, faces, creases and corners for Catmull-Clark
/// subdivision. Sharpnesses of 10 and above become 10, which is USD's word for infinitely sharp. The mesh
/// must be well formed (topology.h) and finite.
/// @param metres_a_unit  > 0
std::string usda_text(const QuadMesh& mesh, double metres_a_unit = 1);

}  // namespace sinew
