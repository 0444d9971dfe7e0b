/// @file station.h
/// The rings of all paths: where they stand, how they are turned, what their vertices lie on, and what must
/// stay true of them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sinew/extend/plain.h"

namespace sinew::sqm {

enum class RingShape : std::uint8_t {
    circle,   ///< an ellipse of half extents Station::half in the ring's plane
    node,     ///< where the plane of the ring cuts the round cones of the two bones that meet at the node
    outline,  ///< a rectangle of half extents Station::half, corner by corner at the path's corner columns
    follow,   ///< between the joint's own ring and the next one, on the joint's surface
    pit,      ///< on the wall of a dent, at Station::share of its width
};

/// What the smooth surface, not the control mesh, has to do with a ring.
enum class RingFit : std::uint8_t {
    through,  ///< it passes through the ring
    held,     ///< it is as wide as if the rings on both sides were the same: a stop to what they do
    cap,      ///< the ring belongs to a round end, whose rings are fitted together
};

/// A ring of vertices. Vertex k is seen from the centre at the angle Stations::angle[k] + turn, from x
/// towards y.
struct Station {
    Vec3 centre = Vec3::Zero();
    Vec3 tangent = Vec3::UnitZ();  ///< unit normal of the ring's plane, along the path
    Vec3 x = Vec3::UnitX();        ///< unit, in the plane; carried along the path with the least turning
    Vec3 form_x = Vec3::UnitX();   ///< unit: the axis of half.x()
    Vec2 half = Vec2::Ones();      ///< half extents; equal ones are a radius
    Vec3 bend =
        Vec3::Zero();  ///< in the plane: outlines are this much wider along it, since a bend cuts them askew
    double turn = 0;   ///< radians; carries the twist between both ends
    float near_share = 0, far_share = 0;  ///< how much of the uneven spacing of a joint's ring is left here
    float share = 0;  ///< follow: how far from the joint's ring to the next; pit: width, in (0, 1]
    float along = 0;  ///< parameter on the bone, 0 at the bone's first node
    std::int32_t before = -1, node = -1, after = -1;  ///< nodes: the one this belongs to and its neighbours
    std::int32_t bone = -1;                           ///< the bone it stands on
    float crease = 0;                                 ///< sharpness of the ring's edges
    float lines = 0;  ///< sharpness of the edges at the corner columns, from here to the next ring
    RingShape shape = RingShape::circle;
    std::uint8_t corner =
        0;               ///< outline: which quarter turn of the outline is at the path's first corner column
    bool far = false;    ///< follow, pit: the joint is the one at the path's end
    bool round = false;  ///< subdivision keeps the ring on its circle
    bool corners = false;  ///< its corner vertices never move
    RingFit fit = RingFit::through;
    BoneKind to_next = BoneKind::tube;  ///< side, plate: the faces from here to the next ring are flat
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
    std::vector<std::int32_t> corner;  ///< path -> its first corner column; -1 if it has no corners
    std::vector<std::array<std::uint8_t, 2>>
        crowded;  ///< path -> whether a ring on its first and its last bone is too wide for the joint's cell
};

struct StationOptions {
    /// Rings beside round ends and the bases of tips too, as there are beside joints: a smooth surface needs
    /// them to keep the radius from there on.
    bool support = false;
    /// Rings that no quad of a tube is longer than so many times its width, or than this length; 0: no limit.
    double aspect = 0;
    double edge_length = 0;
};

/// Whether a ring may be pulled into the cell of the joint that a bone leaves: it is on the bone, or at the
/// node beyond it, and of no form that was asked for.
inline bool may_be_pulled(const Station& ring, std::int32_t bone, std::int32_t node) {
    if (ring.shape == RingShape::node) return ring.bone == bone || ring.node == node;
    return ring.shape == RingShape::circle && ring.bone == bone && !ring.round && ring.crease == 0;
}

/// Column that carries corner 0, 1, 2 or 3 of a path of `sides` columns.
inline std::int32_t corner_column(std::int32_t first_corner, int corner, std::int32_t sides) {
    return (first_corner + (corner * sides + 2) / 4) % sides;
}

}  // namespace sinew::sqm
