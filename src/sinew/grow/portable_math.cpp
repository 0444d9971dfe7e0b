#include "sinew/grow/portable_math.h"

#include <array>
#include <cmath>
#include <limits>

namespace sinew::lsystem {
namespace {

constexpr double degree = 0.017453292519943295;

/// c[0] + c[1] x + c[2] x^2 ...
template <std::size_t N>
double polynomial(const std::array<double, N>& c, double x) {
    double sum = c[N - 1];
    for (std::size_t i = N - 1; i-- > 0;) sum = sum * x + c[i];
    return sum;
}

// Taylor's series; on [-pi/4, pi/4] what is left out is below 2^-56.
double sine_near_zero(double x) {
    constexpr std::array c{1.0,          -1.0 / 6,        1.0 / 120,        -1.0 / 5040,
                           1.0 / 362880, -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000};
    return x * polynomial(c, x * x);
}
double cosine_near_zero(double x) {
    constexpr std::array c{1.0,
                           -1.0 / 2,
                           1.0 / 24,
                           -1.0 / 720,
                           1.0 / 40320,
                           -1.0 / 3628800,
                           1.0 / 479001600,
                           -1.0 / 87178291200,
                           1.0 / 20922789888000};
    return polynomial(c, x * x);
}

/// sin(degrees + 90 turns). The reduction is exact: fmod and the subtraction make no rounding error.
double sine_of_quarters(double degrees, int turns) {
    const double rest = std::fmod(degrees, 360.0);
    if (!std::isfinite(rest)) return std::numeric_limits<double>::quiet_NaN();
    const double quarter = std::nearbyint(rest / 90.0);
    const double x = (rest - 90.0 * quarter) * degree;
    switch ((static_cast<int>(quarter) + turns + 8) % 4) {
        case 0:
            return sine_near_zero(x);
        case 1:
            return cosine_near_zero(x);
        case 2:
            return -sine_near_zero(x);
        default:
            return -cosine_near_zero(x);
    }
}

double whole_power(double x, unsigned n) {
    double result = 1;
    for (; n; n >>= 1, x *= x)
        if (n & 1) result *= x;
    return result;
}

}  // namespace

double sine(double degrees) { return sine_of_quarters(degrees, 0); }
double cosine(double degrees) { return sine_of_quarters(degrees, 1); }

double exponential(double x) {
    if (!(x < 710)) return x * std::numeric_limits<double>::infinity();
    if (x < -750) return 0;
    constexpr double ln2_high = 0x1.62e42feep-1, ln2_low = 0x1.a39ef35793c76p-33;
    const double k = std::nearbyint(x / (ln2_high + ln2_low));
    const double r = (x - k * ln2_high) - k * ln2_low;
    double term = 1, sum = 1;
    for (int i = 1; i < 18; ++i) sum += term *= r / i;
    return std::ldexp(sum, static_cast<int>(k));
}

double logarithm(double x) {
    if (x == 0) return -std::numeric_limits<double>::infinity();
    if (!(x > 0)) return std::numeric_limits<double>::quiet_NaN();
    if (std::isinf(x)) return x;
    int exponent = 0;
    double mantissa = std::frexp(x, &exponent);
    if (mantissa < 0.70710678118654752) mantissa *= 2, --exponent;
    const double s = (mantissa - 1) / (mantissa + 1);  // log m = 2 artanh s, |s| < 0.172
    double sum = 0;
    for (int i = 23; i > 0; i -= 2) sum = sum * s * s + 1.0 / i;
    constexpr double ln2_high = 0x1.62e42feep-1, ln2_low = 0x1.a39ef35793c76p-33;
    return exponent * ln2_high + (exponent * ln2_low + 2 * s * sum);
}

double power(double x, double y) {
    if (y == std::nearbyint(y) && std::fabs(y) < 1 << 30) {
        const double p = whole_power(x, static_cast<unsigned>(std::fabs(y)));
        return y < 0 ? 1 / p : p;
    }
    if (x == 0) return y > 0 ? 0 : std::numeric_limits<double>::infinity();
    return exponential(y * logarithm(x));
}

double arc_tangent(double y, double x) {
    if (x == 0 && y == 0) return 0;
    // The angle is halved three times, which leaves less than 12 degrees for the series.
    double angle_factor = 1;
    const double length = std::sqrt(x * x + y * y);
    double c = x / length, s = y / length;
    if (s == 0) return c > 0 ? 0 : 180;
    for (int i = 0; i < 4; ++i, angle_factor *= 2) {
        // tan(a/2) = sin a / (1 + cos a), or (1 - cos a) / sin a where that would cancel
        const double t = c > 0 ? s / (1 + c) : (1 - c) / s;
        const double scale = 1 / std::sqrt(1 + t * t);
        c = scale, s = t * scale;
    }
    const double t = s / c;
    double sum = 0;
    for (int i = 21, sign = 1; i > 0; i -= 2, sign = -sign) sum = sum * t * t + sign * 1.0 / i;
    return t * sum * angle_factor / degree;
}

}  // namespace sinew::lsystem
