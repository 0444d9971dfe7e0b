/// @file portable_math.h
/// Elementary functions made of additions, multiplications, divisions and square roots only, so that the same
/// input gives the same bits on every machine. The C library's differ in the last place between processors
/// and versions. Error: a few units in the last place.
#pragma once

#include <span>

namespace sinew::portable {

struct SineCosine {
    double sine, cosine;
};
/// Of an angle in radians, up to a million of them; its reduction costs no accuracy there.
SineCosine sine_cosine(double radians);
/// The same of many at once, several in one instruction: they are written to `to`.
void sine_cosine(std::span<const double> radians, SineCosine* to);
/// Angle of the point (x, y) in radians, in (-pi, pi]; 0 at the origin. Exact at multiples of a right angle.
double angle_of(double y, double x);
/// Angle in [-pi/2, pi/2] that has this sine, which is in [-1, 1].
double arc_sine(double sine);

/// Of an angle in degrees; exact at multiples of 90.
double sine(double degrees);
double cosine(double degrees);
/// Degrees in (-180, 180].
double arc_tangent(double y, double x);

double exponential(double x);
double logarithm(double x);  ///< natural; -inf at 0, NaN below

/// Repeated products for whole exponents, exponential(y logarithm(x)) for others; NaN as the C library's.
double power(double x, double y);

}  // namespace sinew::portable
