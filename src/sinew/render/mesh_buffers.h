/// @file mesh_buffers.h
/// A QuadMesh as a graphics card wants it: one vertex a face corner, triangles, and what is marked on demand.
///
/// A corner carries its place in the face, so that the shader draws the edges of the faces and not the
/// diagonals of the triangles, without a second pass.
#pragma once

#include <cstdint>
#include <vector>

#include "sinew/mesh/quad_mesh.h"
#include "sinew/render/bounds.h"
#include "sinew/render/overlay.h"

namespace sinew {

/// How MeshVertex::u and v tell the distance to the face's edges; 255 is 1.
enum class FacePart : std::uint8_t {
    quad,      ///< edges where u or v is 0 or 1
    triangle,  ///< edges where u, v or 1 - u - v is 0
    fan,       ///< a piece of a face of five or more sides: the edge is where u is 0
};

struct MeshVertex {
    MeshVertex() {}  ///< sets nothing: room for many is made before they are written, and not filled twice
    float position[3];
    std::uint32_t normal;       ///< smooth; three signed 10-bit numbers, x lowest
    std::uint32_t face_normal;  ///< of the whole face
    std::uint8_t u, v;
    FacePart part;
    std::uint8_t unused;
};
static_assert(sizeof(MeshVertex) == 24);

struct MeshBuffers {
    std::vector<MeshVertex> vertices;
    std::vector<std::uint32_t> triangles;  ///< three vertices each, counter-clockwise seen from outside
    std::vector<PointMark>
        irregular;  ///< vertices of a valence other than 4, coloured by valence, poles apart
    std::vector<LineMark> creases;
    Bounds bounds;
};

/// Smooth normals stop at creases of sharpness 1 and above. Normals of faces without an area are zero or
/// borrowed from their neighbours; nothing fails. Linear time.
MeshBuffers mesh_buffers(const QuadMesh& mesh);

}  // namespace sinew
