/// @file path_work.h
/// One path while its rings are found. Internal to the stations.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "sinew/base/portable_math.h"
#include "sinew/sqm/points/joint_points.h"
#include "sinew/sqm/rings/station.h"

namespace sinew::sqm {

/// What a joint takes of the path that leaves it.
struct JointSide {
    std::int32_t joint = -1, cell = -1;
    Vec3 centre = Vec3::Zero(), axis = Vec3::UnitZ();  ///< the bone's direction from there
    std::vector<std::uint32_t> ring;                   ///< its points, counter-clockwise in the path's sense
    std::vector<Vec3> points;                          ///< their places, from the joint's centre
    double reach = 0;                                  ///< how far they go along the bone
    double farthest = 0;                               ///< and from the joint's centre
    double widest = 1;  ///< cosine of the greatest angle between one of them and the bone
    double room = 0;    ///< tangent of the least angle between the bone and the cell's border; 0: no limit

    bool any() const { return joint >= 0; }
};

struct PathWork {
    const Plain& s;
    const Network& n;
    const Polyhedra& p;
    const Refinement& r;
    const JointSurfaces& surfaces;
    const JointPoints& points;
    const StationOptions& options;
    Stations& out;

    std::int32_t path = 0, sides = 0;
    std::span<const std::int32_t> nodes, bones;
    bool closed = false;
    bool plain = false;               ///< no node of the path has a form
    double edge = 1;                  ///< of a ring of radius 1
    portable::SineCosine step{0, 1};  ///< of the angle from a column to the next, spread evenly
    JointSide near, far;
    std::vector<Station> rings;

    // Working memory.
    std::vector<std::uint8_t> kept;   ///< node -> whether its ring is not left out
    std::vector<std::uint8_t> bored;  ///< bone -> whether the path bores a hole there; empty if nowhere
    std::vector<double> heights, distance, near_angles, far_angles;
    std::vector<std::pair<double, double>> anchors;

    std::int32_t count() const { return static_cast<std::int32_t>(nodes.size()); }
    std::int32_t bone_count() const { return closed ? count() : count() - 1; }
    std::int32_t node(std::int32_t i) const {
        return nodes[i < 0 ? i + count() : i < count() ? i : i - count()];
    }
    const Vec3& position(std::int32_t i) const { return s.position[node(i)]; }
    double radius(std::int32_t i) const { return s.radius[node(i)]; }
    const Form* form(std::int32_t i) const { return plain ? nullptr : s.form(node(i)); }
    Vec3 direction(std::int32_t bone) const { return (position(bone + 1) - position(bone)).normalized(); }
    BoneKind kind(std::int32_t bone) const { return s.bone_kind[bones[bone]]; }
    bool is_inner(std::int32_t i) const { return closed || (i > 0 && i + 1 < count()); }
    double edge_of(double radius) const { return edge * radius; }
    /// Direction of a bone as its rings see it: against it where the path bores a hole.
    Vec3 way(std::int32_t bone) const {
        return bored.empty() || !bored[bone] ? direction(bone) : Vec3(-direction(bone));
    }

    /// The form of a node, if that is a ring's.
    const Form* ring_form(std::int32_t i) const {
        const Form* f = form(i);
        return f && f->kind == Form::Kind::ring ? f : nullptr;
    }
    bool is_fixed(std::int32_t i) const { return ring_form(i) && ring_form(i)->fixed; }
    bool is_rectangular(std::int32_t i) const {
        return ring_form(i) && ring_form(i)->section == Section::rectangular;
    }
    bool is_shaped(std::int32_t i) const {
        const Form* f = ring_form(i);
        return f && (f->section == Section::rectangular || f->half.x() != f->half.y());
    }

    /// How far the ring at a node leans over its bones, on the inner side of the bend; at most so many radii.
    double lean(std::int32_t i, double most = 1) const {
        if (is_fixed(i)) return 0;
        const double cosine = std::clamp(way(i - 1).dot(way(i)), -1.0, 1.0);
        return radius(i) * std::min(most, std::sqrt((1 - cosine) / (1 + cosine + 1e-12)));
    }
};

/// Appends a ring of the given radius, that stands on a bone at the share `along` of its length.
inline Station& add_ring(PathWork& w, const Vec3& centre, const Vec3& tangent, double radius,
                         std::int32_t bone, double along) {
    Station& ring = w.rings.emplace_back();
    ring.centre = centre;
    ring.tangent = tangent;
    ring.half = {radius, radius};
    ring.bone = w.bones[bone];
    const bool forward = w.s.bones[ring.bone][0] == w.node(bone);
    ring.along = static_cast<float>(std::clamp(forward ? along : 1 - along, 0.0, 1.0));
    ring.node = w.node(along > 0.5 ? bone + 1 : bone);
    return ring;
}

}  // namespace sinew::sqm
