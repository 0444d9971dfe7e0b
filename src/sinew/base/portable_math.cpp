#include "sinew/base/portable_math.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace sinew::portable {
namespace {

constexpr double pi = 3.14159265358979324;
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

/// Arc tangent for |x| <= tan(pi/32); what is left out is below 2^-56 of it.
double arc_tangent_near_zero(double x) {
    constexpr std::array c{1.0, -1.0 / 3, 1.0 / 5, -1.0 / 7, 1.0 / 9, -1.0 / 11, 1.0 / 13, -1.0 / 15};
    return x * polynomial(c, x * x);
}

double whole_power(double x, unsigned n) {
    double result = 1;
    for (; n; n >>= 1, x *= x)
        if (n & 1) result *= x;
    return result;
}

inline SineCosine turn(double radians) {
    // A quarter turn in three parts, of which k times the first two are exact.
    constexpr double high = 0x1.921fb544p0, middle = 0x1.0b4611a6p-34, low = 0x1.3198a2e037073p-69;
    constexpr double round = 0x1.8p52;  // adding it rounds to a whole number: the last bits of the sum
    const double rounded = radians * 0.63661977236758134 + round, k = rounded - round;
    const double x = ((radians - k * high) - k * middle) - k * low;
    const auto s = std::bit_cast<std::uint64_t>(sine_near_zero(x)),
               c = std::bit_cast<std::uint64_t>(cosine_near_zero(x));
    // Odd quarters exchange them, and two of four have the other sign. By bits, without a branch, so that the
    // compiler can do several angles in one instruction.
    const auto quarter = std::bit_cast<std::uint64_t>(rounded), exchange = (s ^ c) & -(quarter & 1);
    return {std::bit_cast<double>(s ^ exchange ^ (quarter & 2) << 62),
            std::bit_cast<double>(c ^ exchange ^ ((quarter + 1) & 2) << 62)};
}

}  // namespace

SineCosine sine_cosine(double radians) { return turn(radians); }
void sine_cosine(std::span<const double> radians, SineCosine* to) {
    for (std::size_t i = 0; i < radians.size(); ++i) to[i] = turn(radians[i]);
}

double angle_of(double y, double x) {
    if (x == 0 && y == 0) return 0;
    const double across = std::fabs(x), up = std::fabs(y);
    const bool steep = up > across;
    const double small = steep ? across : up, large = steep ? up : across;
    // Less the nearest multiple of pi/16, whose tangents these are.
    constexpr std::array tangent{0.0, 0.198912367379658006911597622645, 0.414213562373095048801688724210,
                                 0.668178637919298919997757686523, 1.0};
    constexpr std::array limit{0.0984914033571642530771975212913, 0.303346683607342391675883946941,
                               0.534511135950791641089685961295, 0.820678790828660330972281985331};
    int k = 0;
    for (const double l : limit) k += small > l * large;
    const double t = tangent[k];
    double angle = k * (pi / 16) + arc_tangent_near_zero((small - t * large) / (large + t * small));
    if (steep) angle = pi / 2 - angle;
    if (x < 0) angle = pi - angle;
    return y < 0 ? -angle : angle;
}

double arc_sine(double sine) { return angle_of(sine, std::sqrt((1 - sine) * (1 + sine))); }

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

double arc_tangent(double y, double x) { return angle_of(y, x) / degree; }

}  // namespace sinew::portable
