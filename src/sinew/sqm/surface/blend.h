/// @file blend.h
/// The round cones of a joint, blended where they meet in a crotch.
///
/// A ball that rolls outside the union of the cones leaves a fillet where two of them meet: this is the closing of the
/// union by the ball (J. Serra, "Image Analysis and Mathematical Morphology", 1982). Convex places and lone tubes
/// stay as they are. Each pair of cones is taken as the pair of planes that touch them next to a place, for which
/// the fillet is a cylinder: exact where the cones are straight across the crotch, and close to it elsewhere.
#pragma once

#include "sinew/sqm/surface/joint_surface.h"

namespace sinew::sqm {

/// Signed distance of a place to the surface of a joint without a body, dents left aside; negative inside. No
/// greater than that to the union of its cones.
/// @param from_centre  the place, seen from the joint's centre
double blended_distance(const Network& network, const JointSurfaces& surfaces, std::int32_t joint,
                        const Vec3& from_centre);

/// Where the ray from the joint's centre leaves the blended surface.
/// @param ray   unit
/// @param exit  where it leaves the union of the cones
double blended_exit(const Network& network, const JointSurfaces& surfaces, std::int32_t joint,
                    const Vec3& ray, double exit);

}  // namespace sinew::sqm
