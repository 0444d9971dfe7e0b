/// @file refine.h
/// One step of subdivision: positions of a level to positions of the next.
#pragma once

#include "sinew/subdivide/finer_rules.h"

namespace sinew {

/// Everything but positions that a step needs.
struct Step {
    std::span<const Level> levels;  ///< from the control mesh to the one that is refined, the last
    const SurfaceRules& rules;      ///< of that level
    const Flats& finer_flats;       ///< of the next
    const Features& features;       ///< where circles and planes are; no more is read

    const Level& level() const { return levels.back(); }
};

/// Refines positions. Each new one is computed on its own from old ones, in a fixed order: the same bytes on
/// any number of threads.
/// @param coarse  positions of the last level; changed on the way, restored at the end
/// @param finer   receives the old vertices, the new points of the edges, and those of the faces
void refine_positions(const Step& step, std::span<Vec3f> coarse, std::span<Vec3f> finer);

/// Puts the vertices of circles, as far as they are off it by more than a millionth of the radius, on their
/// circle.
void put_on_circles(const Rounds& rounds, const Features& features, std::span<Vec3f> positions);

/// Replaces the vertices of circles by the control points that the surface beside them sees.
/// @return the positions that were there, in the order of rounds.vertices
std::vector<Vec3f> show_circle_controls(const Rounds& rounds, const Features& features,
                                        std::span<Vec3f> positions);
void restore_circles(const Rounds& rounds, std::span<const Vec3f> saved, std::span<Vec3f> positions);

/// Puts the rims of planes back into them.
void put_in_planes(const Flats& flats, const Features& features, std::span<Vec3f> positions);

}  // namespace sinew
