/// @file normals.h
/// Normals to light a mesh with.
#pragma once

#include <cstdint>
#include <vector>

#include "sinew/mesh/quad_mesh.h"

namespace sinew {

/// The normal of one face corner whose vertex has several, since creases meet there.
struct SplitNormal {
    std::uint32_t corner = 0;  ///< index in QuadMesh::corners
    Vec3f normal = Vec3f::Zero();
};

/// Unit normals, outward; zero where there is none to be had (a face without an area, a vertex without a
/// face).
struct Normals {
    std::vector<Vec3f> faces;
    std::vector<Vec3f> vertices;
    std::vector<SplitNormal> splits;  ///< in ascending order; these corners do not take their vertex's normal
};

/// A vertex's normal is that of mesh/normals.h, in single precision, which is enough to light by. Creases of
/// sharpness 1 and above part the faces. Linear time.
Normals normals_of(const QuadMesh& mesh);

}  // namespace sinew
