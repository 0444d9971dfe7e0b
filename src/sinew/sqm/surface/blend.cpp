#include "sinew/sqm/surface/blend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sinew::sqm {
namespace {

/// Of all cones of a joint those nearest to a place: a fillet between farther ones is inside that of these.
constexpr std::size_t most_near = 4;
/// Cosine between two normals from which both cones are one surface: both share the ball of the joint.
constexpr double same_surface = 0.999;
/// A ray gains on the surface by the distance to it, as in sphere tracing (J. C. Hart, 1996): so many times, until it
/// gains less than this share of the rolling ball.
constexpr int most_steps = 12;
constexpr double close_enough = 1e-3;

struct NearCone {
    double distance = std::numeric_limits<double>::infinity();
    std::int32_t slot = -1;
};

/// Adds a cone to the nearest ones, which stay in order.
void keep_nearest(std::array<NearCone, most_near>& nearest, const NearCone& cone) {
    NearCone in = cone;
    for (NearCone& kept : nearest)
        if (in.distance < kept.distance) std::swap(in, kept);
}

/// Signed distance to the fillet that a ball leaves between two planes at the distances a and b, both nearer than its radius;
/// the distance to the nearer plane where the ball does not touch both.
double fillet(double a, double b, double cosine, double ball) {
    // The way from the ball's centre is made of both normals: along * normal_a + across * normal_b.
    const double to_a = a - ball, to_b = b - ball, square = 1 - cosine * cosine;
    const double along = (to_a - to_b * cosine) / square, across = (to_b - to_a * cosine) / square;
    if (along >= 0 || across >= 0) return std::min(a, b);
    return ball - std::sqrt(along * to_a + across * to_b);
}

}  // namespace

double blended_distance(const Network& n, const JointSurfaces& surfaces, std::int32_t joint,
                        const Vec3& from) {
    std::array<NearCone, most_near> nearest;
    for (std::int32_t slot = n.slot_first[joint]; slot < n.slot_first[joint + 1]; ++slot)
        keep_nearest(nearest, {surfaces.cone[slot].distance(from), slot});
    const double ball = surfaces.rolling.empty() ? 0 : surfaces.rolling[joint];
    double least = nearest[0].distance;
    if (!(ball > 0)) return least;
    std::size_t count = 0;
    while (count < most_near && nearest[count].slot >= 0 && nearest[count].distance < ball) ++count;
    if (count < 2) return least;
    std::array<Vec3, most_near> normal;
    for (std::size_t i = 0; i < count; ++i) normal[i] = surfaces.cone[nearest[i].slot].normal(from);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 1; j < count; ++j) {
            const double cosine = normal[i].dot(normal[j]);
            if (std::abs(cosine) < same_surface)
                least = std::min(least, fillet(nearest[i].distance, nearest[j].distance, cosine, ball));
        }
    return least;
}

double blended_exit(const Network& n, const JointSurfaces& surfaces, std::int32_t joint, const Vec3& ray,
                    double exit) {
    if (surfaces.rolling.empty() || !(surfaces.rolling[joint] > 0)) return exit;
    const double enough = close_enough * surfaces.rolling[joint];
    for (int step = 0; step < most_steps; ++step) {
        const double inside = -blended_distance(n, surfaces, joint, exit * ray);
        if (!(inside > enough)) break;
        exit += inside;
    }
    return exit;
}

}  // namespace sinew::sqm
