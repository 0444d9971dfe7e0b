/// @file stations.h
/// Finds the rings of all paths.
///
/// In: the skeleton, its network, and what was found of its joints. Out: the stations of every path, in its
/// order, with their places, sizes and turns. Paths are worked on in parallel, each by itself: what a joint
/// takes of it (joint_side.h), where its rings stand (path_rings.h), how they are turned (path_angles.h), and
/// the rings that follow a joint's surface (follow_rings.h). Linear in what is made; cannot fail.
#pragma once

#include "sinew/sqm/points/joint_points.h"
#include "sinew/sqm/rings/station.h"

namespace sinew::sqm {

Stations make_stations(const Plain& skeleton, const Network& network, const Polyhedra& polyhedra,
                       const Refinement& refinement, const JointSurfaces& surfaces, const JointPoints& points,
                       const StationOptions& options = {});

}  // namespace sinew::sqm
