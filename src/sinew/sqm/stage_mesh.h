/// @file stage_mesh.h
/// What a stage found, as a mesh that one can look at.
#pragma once

#include "sinew/mesh/quad_mesh.h"
#include "sinew/sqm/points/joint_points.h"

namespace sinew::sqm {

/// SQM's branch node polyhedra: for each joint the hull of its bones' directions, on its ball. Faces are
/// polygons; those of three bones, and of bones in a plane, lie back to back.
QuadMesh polyhedra_mesh(const Plain& skeleton, const Network& network, const Polyhedra& polyhedra);

/// The balls of the joints, tiled: a polygon a cell, with the vertices that its ring will have.
QuadMesh refined_mesh(const Plain& skeleton, const Network& network, const Polyhedra& polyhedra,
                      const Refinement& refinement, const JointPoints& points);

}  // namespace sinew::sqm
