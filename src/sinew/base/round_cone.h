/// @file round_cone.h
/// The ideal surface: the union of round cones, the hulls of the two balls at the ends of each bone.
#pragma once

#include <algorithm>
#include <cmath>

#include "sinew/base/vec.h"

namespace sinew {

/// A round cone as seen from the ball at its near end, whose centre is the origin of all rays.
struct ConeFrom {
    Vec3 axis = Vec3::UnitZ();  ///< unit, to the far end
    double length = 0;          ///< between the two centres
    double near = 1, far = 1;   ///< the radii
    double sine = 0;            ///< of the slope of the side: (near - far) / length, in [-1, 1]
    double cosine = 1;

    ConeFrom() = default;
    ConeFrom(const Vec3& from, double near_radius, const Vec3& to, double far_radius)
        : length((to - from).norm()), near(near_radius), far(far_radius) {
        if (length > 0) axis = (to - from) / length;
        nested_ = std::abs(near - far) >= length;
        if (!nested_) {
            sine = (near - far) / length;
            cosine = std::sqrt((1 - sine) * (1 + sine));
        }
    }

    /// Distance from the near centre to where a ray along the unit vector leaves the cone. The cone is convex
    /// and holds the centre, so there is one such point.
    double exit(const Vec3& ray) const {
        const double along = ray.dot(axis);
        if (nested_ ? near >= far : along <= sine) return near;  // the ray leaves through the near ball
        const double across = std::sqrt(std::max(0.0, 1 - along * along));
        if (nested_) return leave_far(along, across);
        const double rise = along * cosine - across * sine;  // height on the slanted side, a unit of the ray
        const double t = near / (across * cosine + along * sine);
        if (t > 0 && t * rise <= length * cosine) return t;
        return leave_far(along, across);
    }

    /// Whether a point, seen from the near centre, is inside. Cheaper than `exit`.
    bool holds(const Vec3& point) const {
        const double along = point.dot(axis), square = point.squaredNorm();
        if (square <= near * near) return true;
        if (!nested_) {
            const double across = std::sqrt(std::max(0.0, square - along * along));
            const double rise = along * cosine - across * sine;
            if (rise <= 0) return false;
            if (rise < length * cosine) return across * cosine + along * sine <= near;
        }
        return square + length * (length - 2 * along) <= far * far;
    }

    /// Signed distance of a point, seen from the near centre: negative inside.
    double distance(const Vec3& point) const {
        // In the plane of the axis and the point: which of the two balls, or the slanted side between them, is
        // nearest?
        const double along = point.dot(axis), across = (point - along * axis).norm();
        const double beyond = along - length;
        const double to_near = std::sqrt(along * along + across * across) - near;
        const double to_far = std::sqrt(beyond * beyond + across * across) - far;
        if (nested_) return std::min(to_near, to_far);
        const double rise = along * cosine - across * sine;
        if (rise <= 0) return to_near;
        return rise >= length * cosine ? to_far : across * cosine + along * sine - near;
    }

    /// Unit normal of the surface next to a point, seen from the near centre: where distance() grows.
    Vec3 normal(const Vec3& point) const {
        const double along = point.dot(axis);
        const Vec3 side = point - along * axis, from_far = point - length * axis;
        const double across = side.norm();
        const auto away = [&](const Vec3& v) { return v.squaredNorm() > 0 ? Vec3(v.normalized()) : axis; };
        if (nested_) return away(point.norm() - near < from_far.norm() - far ? point : from_far);
        const double rise = along * cosine - across * sine;
        if (rise <= 0) return away(point);
        if (rise >= length * cosine) return away(from_far);
        return across > 0 ? Vec3(cosine / across * side + sine * axis) : axis;
    }

    /// Heights above the near centre at which the straight side begins and ends.
    double side_begin() const { return near * sine; }
    double side_end() const { return length + far * sine; }

    /// Radius at a height above the near centre, of the side or of the balls before and behind it; 0 outside.
    double radius_at(double height) const {
        auto ball = [](double radius, double h) {
            return std::sqrt(std::max(0.0, (radius - h) * (radius + h)));
        };
        if (nested_) return std::max(ball(near, height), ball(far, height - length));
        if (height <= side_begin()) return ball(near, height);
        if (height >= side_end()) return ball(far, height - length);
        return (near - height * sine) / cosine;
    }
    bool nested() const { return nested_; }

  private:
    double leave_far(double along, double across) const {
        const double square = (far - length * across) * (far + length * across);
        return std::max(near, along * length + std::sqrt(std::max(0.0, square)));
    }
    bool nested_ = true;
};

}  // namespace sinew
