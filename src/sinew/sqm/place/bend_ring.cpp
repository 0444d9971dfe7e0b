#include "sinew/sqm/place/bend_ring.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sinew::sqm {

BendRing::BendRing(const Station& ring, const ConeFrom& before, const ConeFrom& after)
    : ring_(ring), cone_{before, after} {}

void BendRing::give_room(double over_before, double over_after) {
    room_[0] = over_before;
    room_[1] = over_after;
}

void BendRing::keep_from(const Station& next, bool is_before) {
    const ConeFrom& bone = cone_[is_before ? 0 : 1];
    const double here = ring_.tangent.dot(bone.axis), there = next.tangent.dot(bone.axis);
    if (std::abs(here) < 1e-3 || std::abs(there) < 1e-3) return;
    const Vec3 closing = (next.tangent / there - ring_.tangent / here) / (0.98 * bone.length);
    if (closing.norm() * ring_.half.x() > 1) closing_[is_before ? 0 : 1] = closing;
}

/// How far a ray in the plane of the ring may go.
double BendRing::most(const Vec3& ray) const {
    double most = std::numeric_limits<double>::infinity();
    for (int side = 0; side < 2; ++side) {
        const double lean = ray.dot(cone_[side].axis), closing = ray.dot(closing_[side]);
        if (lean > 0) most = std::min(most, room_[side] / lean);
        if (closing > 0) most = std::min(most, 1 / closing);
    }
    return most;
}

/// Along the ring's normal beside a ray, the place where both cones have their sides: with s the sine and c
/// the cosine of a cone's slope and x . d the height along its bone, its side has |x|^2 - r^2 = ((x . d - r
/// s) / c)^2.
bool BendRing::meet(const Vec3& ray, Vec3& place) const {
    const auto& [a, b] = cone_;
    const double r = a.near;
    const Vec3 &along = ring_.tangent, away = a.axis / a.cosine - b.axis / b.cosine;
    const double slant = along.dot(away);
    if (std::abs(slant) < 1e-6) return false;
    // At t times the ray, h = h0 + h1 t along the normal; the height on the side is p + q t.
    const double h0 = r * (a.sine / a.cosine - b.sine / b.cosine) / slant, h1 = -ray.dot(away) / slant;
    const double p = (h0 * along.dot(a.axis) - r * a.sine) / a.cosine,
                 q = (ray.dot(a.axis) + h1 * along.dot(a.axis)) / a.cosine;
    const double square = 1 + h1 * h1 - q * q, half = h0 * h1 - p * q, rest = h0 * h0 - r * r - p * p;
    const double root = half * half - square * rest;
    if (!(square > 1e-6) || root < 0) return false;
    const double t = (std::sqrt(root) - half) / square;
    if (!(t > 0) || p + q * t <= 0) return false;
    place = t * ray + (h0 + h1 * t) * along;
    for (int side = 0; side < 2; ++side) {
        const double height = place.dot(cone_[side].axis);
        if (height > room_[side] || place.dot(closing_[side]) > 1) return false;
    }
    return true;
}

Vec3 BendRing::at(const Vec3& ray) const {
    const double before = cone_[0].exit(ray), after = cone_[1].exit(ray), exit = std::max(before, after);
    Vec3 place;
    if (std::abs(before - after) > 1e-3 * exit && !cone_[0].nested() && !cone_[1].nested() &&
        meet(ray, place))
        return ring_.centre + place;
    return ring_.centre + std::min(exit, most(ray)) * ray;
}

}  // namespace sinew::sqm
