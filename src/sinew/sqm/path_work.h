/// @file path_work.h
/// One path while its rings are found. Internal to the stations.
#pragma once

#include <span>

#include "sinew/sqm/stations.h"

namespace sinew::sqm {

/// What a joint takes of the path that leaves it.
struct JointSide {
    std::int32_t joint = -1, cell = -1;
    Vec3 centre = Vec3::Zero(), axis = Vec3::UnitZ();  ///< the bone's direction from there
    std::vector<std::uint32_t> ring;                   ///< its points, counter-clockwise in the path's sense
    std::vector<Vec3> points;                          ///< their places, from the joint's centre
    double reach = 0;                                  ///< how far they go along the bone
    double farthest = 0;                               ///< and from the joint's centre
    double widest = 1;      ///< cosine of the greatest angle between one of them and the bone
    double narrowest = -1;  ///< and of the least one
    double room = 0;  ///< tangent of the least angle between the bone and the cell's border; 0: no limit

    bool any() const { return joint >= 0; }
};

struct PathWork {
    const Plain& s;
    const Network& n;
    const Polyhedra& p;
    const Refinement& r;
    const JointPoints& points;
    const StationOptions& options;
    Stations& out;

    std::int32_t path = 0, sides = 0;
    std::span<const std::int32_t> nodes, bones;
    bool closed = false;
    double edge = 1;  ///< of a ring of radius 1
    JointSide near, far;
    std::vector<Station> rings;

    // Working memory.
    std::vector<std::uint8_t> kept;
    std::vector<double> heights, distance, near_angles, far_angles;
    std::vector<std::pair<double, double>> anchors;

    std::int32_t count() const { return static_cast<std::int32_t>(nodes.size()); }
    std::int32_t bone_count() const { return closed ? count() : count() - 1; }
    std::int32_t node(std::int32_t i) const { return nodes[(i + count()) % count()]; }
    const Vec3& position(std::int32_t i) const { return s.position[node(i)]; }
    double radius(std::int32_t i) const { return s.radius[node(i)]; }
    const Form* form(std::int32_t i) const { return s.form(node(i)); }
    Vec3 direction(std::int32_t bone) const { return (position(bone + 1) - position(bone)).normalized(); }
    BoneKind kind(std::int32_t bone) const { return s.bone_kind[bones[bone]]; }
    bool is_inner(std::int32_t i) const { return closed || (i > 0 && i + 1 < count()); }
};

/// Rings along the path, from its start to its end, but for the follow rings. @param keep_all leaves out none
/// at nodes.
void place_rings(PathWork& work, bool keep_all);

/// Turns the rings' frames along the path, spreads its columns and the twist, and writes its angles, shift
/// and corners.
void find_angles(PathWork& work);

/// Where the faces between a joint and the first ring would cut off much of the joint's surface, rings follow
/// it.
void add_follow_rings(PathWork& work);

}  // namespace sinew::sqm
