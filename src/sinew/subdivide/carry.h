/// @file carry.h
/// What a mesh has besides positions, one level finer: its faces, where its vertices came from, its features.
#pragma once

#include "sinew/subdivide/finer_rules.h"

namespace sinew {

/// Writes the faces of the level that is finer than `level` into a mesh: quads, and triangles at poles.
void write_finer_faces(const Level& level, QuadMesh& finer);

/// Where the vertices of the finest level came from. A new point takes node and bone of the first of its
/// edge's ends, or of its face's corners, and the mean of the parameters along the bone of those that are on
/// the same bone. What the mesh does not know stays empty.
/// @param levels  those that are split, from the control mesh on
void write_origins(std::span<const Level> levels, const QuadMesh& mesh, QuadMesh& finest);

/// The features of the finest level. Creases come by edge; the rest stays in its order, without the poles
/// that are none.
/// @param levels  those that are split
/// @param rules   those of the last of `levels`
Features finest_features(std::span<const Level> levels, const SurfaceRules& rules, const Features& control);

}  // namespace sinew
