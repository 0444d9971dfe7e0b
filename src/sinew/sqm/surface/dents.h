/// @file dents.h
/// Dents in the surface of a joint, and the grooves that they make where they overlap.
#pragma once

#include "sinew/sqm/surface/joint_surface.h"

namespace sinew::sqm {

/// Fills `surfaces.pits` and what leads there. Expects all else that describes the joints' surfaces. Two
/// dents of a joint that overlap become one groove: more dents stand between them, whose sizes go from one to
/// the other; less where they hardly touch, so that a groove comes and goes smoothly when a dent is moved.
void find_dents(const Plain& skeleton, const Network& network, JointSurfaces& surfaces);

/// Whether the dents of two slots of a joint become one groove; false if one of them is no dent.
bool dents_overlap(const JointSurfaces& surfaces, std::int32_t slot, std::int32_t other);

/// How far a rim may go on the way to its cell's border: beyond is room for the surface beside it.
inline constexpr double widest_rim = 0.93;

/// Whether a joint has any.
bool has_dents(const JointSurfaces& surfaces, std::int32_t joint);

/// Whether the dent of a slot becomes one groove with any other.
bool merges(const JointSurfaces& surfaces, std::int32_t joint, std::int32_t slot);

/// Whether any dents of a joint do.
bool has_groove(const JointSurfaces& surfaces, std::int32_t joint);

/// Where a ray from a joint's centre meets the floor once everything from `distance` on inwards that lies in
/// dents is taken away: the distance. Never quite the centre itself.
double press_dents(const JointSurfaces& surfaces, std::int32_t joint, const Vec3& centre, const Vec3& ray,
                   double distance);

/// Whether a place on a joint's surface is on the wall or the floor of a dent. A rim is outside.
bool in_dent(const Network& network, const JointSurfaces& surfaces, std::int32_t joint, const Vec3& centre,
             const Vec3& place);

/// The same of where a ray from the joint's centre meets its surface.
bool leads_into_dent(const Network& network, const JointSurfaces& surfaces, std::int32_t joint,
                     const Vec3& centre, const Vec3& ray);

/// The ray to where the dents end first, from the axis of one of them towards a ray or beyond it.
Vec3 rim_towards(const Network& network, const JointSurfaces& surfaces, std::int32_t joint,
                 const PitShape& pit, const Vec3& centre, const Vec3& ray);

/// The wall of a joint's dents next to a place on its surface.
struct DentWall {
    Vec3 normal;           ///< out of the solid
    bool touches = false;  ///< the place is on it, or on its rim
};
DentWall nearest_wall(const JointSurfaces& surfaces, std::int32_t joint, const Vec3& place);

/// Whether a place is where the wall of a joint's dents ends.
bool on_rim(const Network& network, const JointSurfaces& surfaces, std::int32_t joint, const Vec3& centre,
            const Vec3& place);

}  // namespace sinew::sqm
