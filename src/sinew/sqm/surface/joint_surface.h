/// @file joint_surface.h
/// The surface round a joint: what each of its bones adds to it, and the ball or box that it may be instead.
///
/// Rays start at the joint's centre, where its node is. Distances are in the skeleton's unit. find_surfaces.h
/// fills it; joint_reach.h asks for all of it, dents included.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sinew/base/round_cone.h"
#include "sinew/sqm/network.h"
#include "sinew/sqm/surface/crowded_slots.h"

namespace sinew::sqm {

/// A bone of scaled or rectangular section, from a joint: a frustum whose outline goes from one half extent
/// to another.
struct BeamFrom {
    Vec3 x, y, z;  ///< z along the bone
    double length = 0;
    Vec2 near, far;  ///< half extents along x and y
    Section section = Section::round;

    /// Where a ray from the middle of the near end leaves the beam; behind it, the outline turned into a cap.
    double exit(const Vec3& ray) const;
};

/// A dent: an ellipsoid whose middle lies on the surface.
struct PitShape {
    Vec3 middle, x, y, z;  ///< z outward
    Vec3 half;             ///< half width, half height, depth

    /// A vector where the ellipsoid is the unit ball.
    Vec3 local(const Vec3& v) const {
        return {v.dot(x) / half.x(), v.dot(y) / half.y(), v.dot(z) / half.z()};
    }
    /// Where a ray from the centre of the joint enters the ellipsoid, if it is inside at `distance`.
    double press(const Vec3& centre, const Vec3& ray, double distance) const;
};

/// What a slot adds to its joint's surface.
enum class SlotKind : std::uint8_t { cone, beam, surface, pit };

struct JointSurfaces {
    // By slot (Network::slot_first).
    std::vector<ConeFrom> cone;  ///< the round cone of the slot's first bone, from the joint
    std::vector<SlotKind> kind;
    std::vector<double> limit;          ///< how far along its bone the joint may reach
    std::vector<std::uint8_t> crowded;  ///< its bone leads straight to a joint, too short for what both want
    std::vector<std::int32_t> extra;    ///< index in beams or pits, by kind
    std::vector<BeamFrom> beams;
    /// Joint by joint: its dents, and more along the grooves that they make where they overlap.
    std::vector<PitShape> pits;
    std::vector<std::int32_t> pit_first;     ///< joint -> its first; joints + 1 entries, none without pits
    std::vector<std::int32_t> groove_first;  ///< joint -> the first of those more; none without pits
    std::vector<const Form*> body;           ///< joint -> its ball or box; null: round cones
    std::vector<double>
        rolling;  ///< joint -> radius of the ball that blends its cones; empty: none is blended
    std::vector<std::uint8_t> only_cones;  ///< joint -> it has no body, and all its slots add cones
    std::vector<CrowdedSlots> crowds;      ///< of the joints of very many bones
    std::vector<std::int32_t> crowd_of;    ///< joint -> index in crowds, -1: none; empty without crowds

    const CrowdedSlots* crowd(std::int32_t joint) const {
        return crowd_of.empty() || crowd_of[joint] < 0 ? nullptr : &crowds[crowd_of[joint]];
    }
    std::span<const ConeFrom> cones(const Network& n, std::int32_t joint) const {
        return {cone.data() + n.slot_first[joint], cone.data() + n.slot_first[joint + 1]};
    }
    std::span<const double> limits(const Network& n, std::int32_t joint) const {
        return {limit.data() + n.slot_first[joint], limit.data() + n.slot_first[joint + 1]};
    }
};

/// Where the ray from a joint's centre leaves its surface before any dent was pressed into it: the distance.
double exit_without_dents(const Network& network, const JointSurfaces& surfaces, std::int32_t joint,
                          const Vec3& ray);

}  // namespace sinew::sqm
