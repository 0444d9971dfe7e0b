/// @file finer_rules.h
/// The features one level finer: what becomes of creases, poles, circles and planes when a level is split.
/// All sparse: the cost is that of the features, not of the mesh.
#pragma once

#include "sinew/subdivide/level.h"

namespace sinew {

/// Each edge becomes two, sharper by 1 less; a new point between them is on the crease.
Sharpness finer_sharpness(const Level& level, const Sharpness& coarse);
/// The valence doubles: the new ring alternates between points of the spokes and of the triangles.
Fans finer_fans(const Level& level, const Fans& coarse);
/// Edges of circles become two; cones keep their faces' parts.
Rounds finer_rounds(const Level& level, const Rounds& coarse);
Flats finer_flats(const Level& level, const Flats& coarse);

SurfaceRules finer_rules(const Level& level, const SurfaceRules& coarse);

}  // namespace sinew
