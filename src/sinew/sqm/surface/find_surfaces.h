/// @file find_surfaces.h
/// What surface each joint has, from the skeleton alone.
///
/// In: the skeleton and its network. Out: for every slot the round cone of its first bone, what it adds to
/// the joint's surface and how far along it the joint may reach; the bodies and the dents of joints. Linear
/// in the skeleton, but for grooves: dents of a joint are compared pair by pair. Cannot fail.
#pragma once

#include "sinew/sqm/surface/joint_surface.h"

namespace sinew::sqm {

JointSurfaces find_surfaces(const Plain& skeleton, const Network& network);

}  // namespace sinew::sqm
