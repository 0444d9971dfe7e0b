/// @file joint_points.h
/// The vertices of the mesh at the joints: where cells meet, and along the arcs between them.
///
/// Each lies on the ideal surface, in its own direction from the joint's centre, so a joint never folds over
/// itself.
#pragma once

#include <cstdint>
#include <vector>

#include "sinew/sqm/ideal.h"
#include "sinew/sqm/refine.h"

namespace sinew::sqm {

struct JointPoints {
    std::vector<std::uint32_t> first;      ///< joint -> its first point; joints + 1 entries
    std::vector<std::uint32_t> arc_first;  ///< arc -> the first of its pieces - 1 inner points
    std::vector<Vec3> position;  ///< joint by joint: its vertices in order, then the inner points arc by arc
    std::vector<ConeFrom> cone;  ///< slot (Network::slot_first) -> the round cone of its bone, from the joint
};

JointPoints make_joint_points(const Plain& skeleton, const Network& network, const Polyhedra& polyhedra,
                              const Refinement& refinement);

/// Where the ray from a joint's centre leaves the round cones of its bones: the distance.
double exit_of_joint(const Network& network, const JointPoints& points, std::int32_t joint, const Vec3& ray);

/// Appends the points round a cell, counter-clockwise seen from outside.
void append_ring(const Polyhedra& polyhedra, const Refinement& refinement, const JointPoints& points,
                 std::int32_t joint, std::int32_t cell, std::vector<std::uint32_t>& ring);

}  // namespace sinew::sqm
