/// @file cell_room.h
/// Where seen from a joint a bone's tube stays within the bone's cell, it cannot meet the joint's other
/// tubes, however narrow the fork and however wide the bones.
#pragma once

#include <vector>

#include "sinew/sqm/cells/polyhedra.h"
#include "sinew/sqm/surface/joint_surface.h"

namespace sinew::sqm {

/// The space before a cell, from the centre of its joint. Its walls go no further than the first bones of the
/// neighbours that they part it from.
class CellRoom {
  public:
    CellRoom(const Plain& skeleton, const Network& network, const Polyhedra& polyhedra,
             const JointSurfaces& surfaces, std::int32_t joint, std::int32_t slot);

    /// A place that is outside, or hardly inside, is moved across the bone towards the middle of the cell.
    Vec3 pull_in(const Vec3& place) const;
    /// How far one can go from a place inside along a unit vector, but for what should be left free; not
    /// further than `most`.
    double free_distance(const Vec3& place, const Vec3& ray, double most) const;

  private:
    struct Wall {
        Vec3 inward;  ///< normal; its product with a vector a unit high over the joint is 1 in the middle
        double until = 0;  ///< distance from the centre
    };
    Vec3 centre_, middle_;
    std::vector<Wall> walls_;
};

}  // namespace sinew::sqm
