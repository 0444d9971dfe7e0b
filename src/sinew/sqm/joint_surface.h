/// @file joint_surface.h
/// The surface round a joint, as far as its points need it.
#pragma once

#include "sinew/sqm/joint_points.h"

namespace sinew::sqm {

/// Fills the parts of `points` that describe the surface: what each slot adds, how far the joint may reach
/// along it, and the bodies of joints.
void find_joint_surfaces(const Plain& skeleton, const Network& network, JointPoints& points);

}  // namespace sinew::sqm
