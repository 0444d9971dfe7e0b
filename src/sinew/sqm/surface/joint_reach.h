/// @file joint_reach.h
/// Where rays from a joint's centre leave its whole surface, dents included.
#pragma once

#include "sinew/sqm/surface/joint_surface.h"

namespace sinew::sqm {

/// Where the ray from a joint's centre leaves its surface: the distance.
double exit_of_joint(const Network& network, const JointSurfaces& surfaces, std::int32_t joint,
                     const Vec3& centre, const Vec3& ray);
/// The same, but no further along any bone than the joint may reach.
double reach_of_joint(const Network& network, const JointSurfaces& surfaces, std::int32_t joint,
                      const Vec3& centre, const Vec3& ray);

}  // namespace sinew::sqm
