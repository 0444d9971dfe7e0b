/// @file rounds.h
/// Circles as subdivision meets them, and the cones and discs that stand on them.
///
/// A vertex of a circle stays where it is, and the new vertex of one of its edges lies on the circle. The
/// surface beside the circle must not see these vertices as control points (a ring of 4 would lose a third of
/// its radius just beside the circle, a waist): it sees `circle_control`, the points of a B-spline that runs
/// along the circle. Between a fixed pole (the tip of a cone, the middle of a flat disc) and a circle round
/// its axis the surface is the exact cone or disc: new vertices there are means in the cone's own
/// coordinates, old ones stay.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sinew/mesh/fans.h"

namespace sinew {

struct CircleVertex {
    std::uint32_t vertex = 0;
    std::uint32_t circle = 0;
    /// Its neighbours along the circle. Both no_index where it is its own control point: at the end of an
    /// arc, at a corner, where two circles or another crease meet.
    std::uint32_t before = no_index;
    std::uint32_t after = no_index;
    std::uint32_t before_edge = no_index;  ///< between it and `before`
    std::uint32_t after_edge = no_index;
};

struct CircleEdge {
    std::uint32_t edge = 0;
    std::uint32_t circle = 0;
};

/// The faces between a tip and a circle.
struct Cone {
    std::uint32_t tip = 0;
    std::uint32_t circle = 0;
    std::vector<std::uint32_t> faces;  ///< ascending
};

struct Rounds {
    std::vector<CircleVertex> vertices;  ///< one entry a vertex
    std::vector<CircleEdge> edges;       ///< circle after circle, in the order of its edges
    std::vector<Cone> cones;
};

/// Fails for an edge of a circle that is no edge of the mesh, and for a circle without axis or radius.
Result<Rounds> resolve_rounds(const QuadMesh& mesh, const Topology& topology, const Sharpness& sharpness,
                              const Fans& fans);

/// The nearest point of a circle; of a point on the axis, any.
Vec3 nearest_on_circle(const Circle& circle, const Vec3& point);

/// Radius of the closed cubic B-spline of points on a circle of radius 1 that are `angle` apart: half way
/// between its greatest, (4 + 2 cos angle) / 6 beside the points, and its least, half way between them.
double spline_radius(double angle);

/// The control point at `point` of the closed cubic B-spline that runs along the circle: further out by 1 /
/// spline_radius of the mean angle to its neighbours before and after.
Vec3 circle_control(const Circle& circle, const Vec3& point, const Vec3& before, const Vec3& after);

/// The mean of points of the cone from a tip to a circle in its own coordinates: the share of the way to the
/// circle, and the direction about the axis. The mean of none but the tip is the tip.
class ConeMean {
  public:
    ConeMean(const Circle& circle, const Vec3& tip) : circle_(circle), tip_(tip) {}
    void add(const Vec3& point);
    Vec3 mean() const;

  private:
    const Circle& circle_;
    Vec3 tip_;
    int count_ = 0;
    double radius_ = 0;
    Vec3 direction_ = Vec3::Zero();
};

}  // namespace sinew
