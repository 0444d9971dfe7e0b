/// @file bend_ring.h
/// The ring at a node of two bones, where their round cones meet.
#pragma once

#include "sinew/base/round_cone.h"
#include "sinew/sqm/rings/station.h"

namespace sinew::sqm {

/// Casts the vertices of such a ring. On the outer side of the bend they lie where its plane cuts the cones.
/// On the inner side they lie where both cones meet, so that the faces on either side stay within their own
/// cone: two round cones about one ball meet in a plane, which leans towards the wider one. No vertex goes so
/// far over a bone that the next ring there would be crossed.
class BendRing {
  public:
    BendRing(const Station& ring, const ConeFrom& before, const ConeFrom& after);

    /// The farthest that the ring may lean over a bone.
    void give_room(double over_before, double over_after);
    /// Vertices that lean over the bone to another bend do not cross that one's plane.
    void keep_from(const Station& next, bool is_before);

    Vec3 at(const Vec3& ray) const;

  private:
    double most(const Vec3& ray) const;
    bool meet(const Vec3& ray, Vec3& place) const;

    const Station& ring_;
    ConeFrom cone_[2];
    double room_[2] = {0, 0};
    Vec3 closing_[2] = {Vec3::Zero(), Vec3::Zero()};  ///< how fast the planes near each other; 0: not at all
};

}  // namespace sinew::sqm
