/// @file path_frame.h
/// Frames that turn as little as possible along a path, and angles round it.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "sinew/base/portable_math.h"
#include "sinew/base/vec.h"
#include "sinew/skeleton/frames.h"

namespace sinew::sqm {

/// Carries the unit vector x, at right angles to tangent a at point p, to tangent b at point q with the least
/// rotation. Double reflection: W. Wang, B. Juettler, D. Zheng, Y. Liu, "Computation of rotation minimizing
/// frames", ACM TOG 27(1), 2008. Both reflections are the same one where the tangents are: x stays.
inline Vec3 carry_frame(const Vec3& x, const Vec3& p, const Vec3& a, const Vec3& q, const Vec3& b) {
    if (a == b) return x;
    const Vec3 chord = q - p;
    const double square = chord.squaredNorm();
    Vec3 xl = x, al = a;
    if (square > 0) {
        xl -= (2 / square) * chord.dot(x) * chord;
        al -= (2 / square) * chord.dot(a) * chord;
    }
    const Vec3 bend = b - al;
    const double bend_square = bend.squaredNorm();
    if (bend_square > 1e-24) xl -= (2 / bend_square) * bend.dot(xl) * bend;
    const Vec3 flat = xl - xl.dot(b) * b;
    const double length = flat.norm();
    return length > 1e-9 ? Vec3(flat / length) : Vec3(frame_about(b).col(0));
}

/// The great circle from one unit direction to another that is neither the same nor opposite.
struct GreatCircle {
    Vec3 from, to;
    double sine, angle;

    GreatCircle(const Vec3& a, const Vec3& b)
        : from(a), to(b), sine(a.cross(b).norm()), angle(portable::angle_of(sine, a.dot(b))) {}
    Vec3 at(double share) const {
        return (portable::sine_cosine((1 - share) * angle).sine * from +
                portable::sine_cosine(share * angle).sine * to) /
               sine;
    }
};

/// Angle of a vector round the axis x cross y, from x towards y.
inline double angle_round(const Vec3& v, const Vec3& x, const Vec3& y) {
    return portable::angle_of(v.dot(y), v.dot(x));
}

/// Angles that do not go once round, as those of a ring that is seen askew: each becomes the nearest one to
/// even spacing, whichever of them is the first.
inline void unwrap_uneven(std::span<double> angles) {
    const double turn = 2 * M_PI, step = turn / static_cast<double>(angles.size());
    double x = 0, y = 0;
    for (std::size_t k = 0; k < angles.size(); ++k) {
        const auto [sine, cosine] = portable::sine_cosine(angles[k] - step * static_cast<double>(k));
        x += cosine, y += sine;
    }
    const double phase = portable::angle_of(y, x);
    for (std::size_t k = 0; k < angles.size(); ++k) {
        const double even = phase + step * static_cast<double>(k);
        angles[k] += turn * std::round((even - angles[k]) / turn);
    }
}

/// Makes angles in (-pi, pi] that go once round increase from the first one on.
inline void unwrap(std::span<double> angles) {
    for (std::size_t k = 1; k < angles.size(); ++k) {
        double step = angles[k] - angles[k - 1];
        while (step < 0) step += 2 * M_PI;
        angles[k] = angles[k - 1] + step;
    }
    if (!angles.empty() && angles.back() - angles.front() > 2 * M_PI) unwrap_uneven(angles);
}

/// The angle g for which g + 2 pi k / n is nearest to the unwrapped angles.
inline double even_phase(std::span<const double> angles) {
    const double n = static_cast<double>(angles.size()), step = 2 * M_PI / n;
    double sum = 0;
    for (std::size_t k = 0; k < angles.size(); ++k) sum += angles[k] - step * static_cast<double>(k);
    return sum / n;
}

}  // namespace sinew::sqm
