/// @file portable_math.h
/// Elementary functions made of additions, multiplications and divisions only, so that a seed gives the same
/// bits on every machine. The C library's differ in the last place between processors and versions. Error: a
/// few units in the last place, which growth does not notice.
#pragma once

namespace sinew::lsystem {

/// Of an angle in degrees; exact at multiples of 90.
double sine(double degrees);
double cosine(double degrees);

double exponential(double x);
double logarithm(double x);  ///< natural; -inf at 0, NaN below

/// Repeated products for whole exponents, exponential(y logarithm(x)) for others; NaN as the C library's.
double power(double x, double y);

/// Degrees in (-180, 180].
double arc_tangent(double y, double x);

}  // namespace sinew::lsystem
