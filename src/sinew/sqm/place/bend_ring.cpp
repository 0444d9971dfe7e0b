#include "sinew/sqm/place/bend_ring.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sinew::sqm {
namespace {

/// How near to each other the planes of two bends may come, of the bone between them, on a line along it.
constexpr double least_between = 0.02;
/// Cosine between a plane's normal and a bone below which the plane is along the bone: it cuts it nowhere.
constexpr double along_bone = 1e-3;
/// How much further out one cone is than the other, of its distance, from which a vertex is on the inner side
/// of the bend: on the outer side the exits are equal but for rounding, and the cones meet at a grazing
/// angle.
constexpr double same_exit = 1e-3;

}  // namespace

BendRing::BendRing(const Station& ring, const ConeFrom& before, const ConeFrom& after)
    : ring_(ring), cone_{before, after} {}

void BendRing::give_room(double over_before, double over_after) {
    room_[0] = over_before;
    room_[1] = over_after;
}

void BendRing::keep_from(const Station& next, bool is_before) {
    const ConeFrom& bone = cone_[is_before ? 0 : 1];
    const double here = ring_.tangent.dot(bone.axis), there = next.tangent.dot(bone.axis);
    if (std::abs(here) < along_bone || std::abs(there) < along_bone) return;
    const Vec3 closing = (next.tangent / there - ring_.tangent / here) / ((1 - least_between) * bone.length);
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

/// In the plane of a ray and the ring's normal, the place where the sides of both cones meet.
///
/// A place x, from the common centre, is on the side of a cone that goes on in the unit direction d if the
/// tangent from there to the ball of radius r has the length of the side below x. With s the sine and c the
/// cosine of the slope the side begins at the height r s, so its length at the height x . d is
/// (x . d - r s) / c, and |x|^2 - r^2 = ((x . d - r s) / c)^2. Both cones have the same |x|^2 - r^2, so both
/// lengths are equal: that is a plane. Put x = t ray + h normal: the plane gives h = h0 + h1 t, the length
/// becomes p + q t, and what is left is the quadratic t^2 + h^2 - r^2 = (p + q t)^2.
bool BendRing::meet(const Vec3& ray, Vec3& place) const {
    const auto& [a, b] = cone_;
    const double r = a.near;
    const Vec3 &along = ring_.tangent, away = a.axis / a.cosine - b.axis / b.cosine;
    const double slant = along.dot(away);
    if (std::abs(slant) < 1e-6) return false;
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
    if (std::abs(before - after) > same_exit * exit && !cone_[0].nested() && !cone_[1].nested() &&
        meet(ray, place))
        return ring_.centre + place;
    return ring_.centre + std::min(exit, most(ray)) * ray;
}

}  // namespace sinew::sqm
