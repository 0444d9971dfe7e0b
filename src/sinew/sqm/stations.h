/// @file stations.h
/// The rings of one path: where they stand, how they are turned, and what their vertices lie on.
#pragma once

#include <cstdint>
#include <vector>

#include "sinew/sqm/joint_points.h"

namespace sinew::sqm {

enum class RingShape : std::uint8_t {
    circle,  ///< of Station::radius about the centre
    node,    ///< where the plane of the ring cuts the round cones of the two bones that meet at the node
    follow,  ///< between the joint's own ring and the next one, on the joint's round cones
};

/// A ring of vertices. Vertex k is seen from the centre at the angle Path::angle[k] + turn, from x towards y.
struct Station {
    Vec3 centre = Vec3::Zero();
    Vec3 tangent = Vec3::UnitZ();  ///< unit normal of the ring's plane, along the path
    Vec3 x = Vec3::UnitX(), y = Vec3::UnitY();
    double radius = 0;
    double turn = 0;                       ///< radians; carries the twist between both ends
    double near_share = 0, far_share = 0;  ///< how much of the uneven spacing of a joint's ring is left here
    double share = 0;                      ///< follow: how far from the joint's ring to the next, in (0, 1)
    std::int32_t before = -1, node = -1,
                 after = -1;  ///< nodes: the one this belongs to and, for `node`, its neighbours
    std::int32_t bone = -1;   ///< the bone it stands on
    float along = 0;          ///< parameter on it, 0 at the bone's first node
    RingShape shape = RingShape::circle;
    bool far = false;  ///< follow: the joint is the one at the path's end
};

/// Rings of many paths, in flat arrays.
struct Stations {
    std::vector<std::int32_t> first;  ///< path -> its first station; paths + 1 entries
    std::vector<Station> stations;
    std::vector<std::int32_t>
        angle_first;            ///< path -> its entries in the three vectors below; paths + 1 entries
    std::vector<double> angle;  ///< even angles of the path's columns
    std::vector<double> near_uneven, far_uneven;  ///< what the joints' rings add to them; 0 at leaves
    std::vector<std::int32_t>
        far_shift;  ///< path -> column k ends in vertex k + shift of the far ring, in the path's sense
};

Stations make_stations(const Plain& skeleton, const Network& network, const Polyhedra& polyhedra,
                       const Refinement& refinement, const JointPoints& points);

}  // namespace sinew::sqm
