/// @file gltf_writer.h
/// glTF 2.0, as one binary file or as JSON: triangles with smooth normals, for viewers and engines.
#pragma once

#include <string>

#include "sinew/base/result.h"
#include "sinew/mesh/quad_mesh.h"

namespace sinew {

/// The mesh as a .glb or a .gltf (with its data in it). Faces are cut into triangles (triangulate.h) in the
/// order of the extension FB_ngon_encoding, from which readers who know it (gltf_reader.h, Blender's add-ons)
/// put quads together again; for others they are plain triangles. Vertices on creases are taken apart
/// (split.h), since a normal is a vertex's: readers who make one of what lies at one place get the mesh back.
/// Our z is up, glTF's y: the node's matrix turns it and makes metres of the units, the vertices keep their
/// positions. The mesh must be well formed (topology.h) and finite. Fails where the file would be larger than
/// the 4 GiB that the format can hold.
/// @param metres_a_unit  > 0
Result<std::string> glb_bytes(const QuadMesh& mesh, double metres_a_unit = 1);
Result<std::string> gltf_text(const QuadMesh& mesh, double metres_a_unit = 1);

}  // namespace sinew
