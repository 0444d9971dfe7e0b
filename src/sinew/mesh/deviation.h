/// @file deviation.h
/// How far a mesh lies from its ideal surface: the union of round cones.
#pragma once

#include "sinew/base/round_cone.h"
#include "sinew/mesh/quad_mesh.h"

namespace sinew {

/// Where round cones are. Arrays of one length.
struct RoundCones {
    std::vector<Vec3> from;       ///< the centre at the near end of each
    std::vector<ConeFrom> cones;  ///< as seen from there

    std::size_t size() const { return from.size(); }
    /// The hull of two balls (centres and radii, in any order); a ball alone has the same end twice.
    void add(const Vec3& a, double a_radius, const Vec3& b, double b_radius) {
        from.push_back(a);
        cones.emplace_back(a, a_radius, b, b_radius);
    }
};

/// For each point: the signed distance d to the union (negative inside: the least over all cones), and the
/// radius r of the closest cone at the point's foot on its axis, at least a thousandth of the largest radius
/// of all.
struct Distances {
    std::vector<double> distance;
    std::vector<double> radius;
};

/// Exact up to rounding; a bounding-volume hierarchy makes it near linear. There must be at least one cone,
/// and all numbers must be finite. The same on any number of threads.
Distances signed_distances(std::span<const Vec3f> points, const RoundCones& cones);

/// d/r over the vertices that have faces; all zero where there are none.
struct Deviation {
    std::int64_t vertices = 0;
    double mean = 0;      ///< of d/r: negative where the mesh is too thin
    double mean_abs = 0;  ///< of |d|/r
    double p95_abs = 0;   ///< 95 of 100 vertices have an |d|/r of at most this (interpolated between ranks)
    double max_abs = 0;
    std::uint32_t worst = 0;  ///< the vertex of max_abs
};

/// The mesh must be well formed (topology.h); vertices that are not finite are passed over.
Deviation measure_deviation(const QuadMesh& mesh, const RoundCones& cones);

}  // namespace sinew
