/// @file triangulate.h
/// Polygons as triangles, for formats and tests that know nothing else.
#pragma once

#include "sinew/mesh/quad_mesh.h"

namespace sinew {

using Triangle = std::array<std::uint32_t, 3>;  ///< vertices, counter-clockwise as their face

struct Triangles {
    std::vector<Triangle> triangles;  ///< face after face
    std::vector<std::uint32_t>
        first;  ///< faces + 1 entries: those of face f are first[f] .. first[f + 1] - 1

    std::span<const Triangle> of(std::size_t face) const {
        return {triangles.data() + first[face], triangles.data() + first[face + 1]};
    }
};

/// Splits each face of n >= 3 corners into n - 2 triangles on its own vertices; smaller faces give none. The
/// mesh must be well formed (topology.h).
///
/// A quad is cut along the diagonal whose two triangles look the same way, the shorter one where both do (a
/// tie: the one with the lowest vertex), so that the cut does not depend on the corner the face starts with.
/// A larger face is a fan from the first corner from which all triangles look the way of the face; one that
/// has no such corner is cut by clipping ears, and one of more than 512 corners then stays a fan from its
/// first.
Triangles triangulate(const QuadMesh& mesh);

/// The triangles of one face: appended to `triangles`.
void triangulate_face(const QuadMesh& mesh, std::size_t face, std::vector<Triangle>& triangles);

}  // namespace sinew
