#include "sinew/base/portable_math.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace sinew::portable {
namespace {

constexpr double pi = 3.141592653589793;

TEST(PortableMath, SineAndCosineAreThoseOfTheAngle) {
    for (double degrees = -1000; degrees < 1000; degrees += 0.37) {
        EXPECT_NEAR(sine(degrees), std::sin(degrees * pi / 180), 1e-14) << degrees;
        EXPECT_NEAR(cosine(degrees), std::cos(degrees * pi / 180), 1e-14) << degrees;
    }
}

TEST(PortableMath, AngleAndPointBelongTogether) {
    for (double radians = -3.14; radians < 3.1416; radians += 0.00371) {
        const auto [s, c] = sine_cosine(radians);
        EXPECT_NEAR(s, std::sin(radians), 3e-16) << radians;
        EXPECT_NEAR(c, std::cos(radians), 3e-16) << radians;
        EXPECT_NEAR(angle_of(7 * s, 7 * c), radians, 1e-15) << radians;
        EXPECT_NEAR(arc_sine(s), std::asin(s), 1e-15) << radians;
    }
    for (const double turns : {-2e5, -12345.0, 0.0, 17.0, 1e5})
        EXPECT_NEAR(sine_cosine(turns + 0.5).sine, std::sin(turns + 0.5), 1e-15) << turns;
}

TEST(PortableMath, ManyAnglesAtOnceGiveTheSameBits) {
    std::vector<double> radians;
    for (int i = 0; i < 1001; ++i) radians.push_back(0.0731 * (i - 500));
    std::vector<SineCosine> many(radians.size());
    sine_cosine(radians, many.data());
    for (std::size_t i = 0; i < radians.size(); ++i) {
        EXPECT_EQ(many[i].sine, sine_cosine(radians[i]).sine);
        EXPECT_EQ(many[i].cosine, sine_cosine(radians[i]).cosine);
    }
}

TEST(PortableMath, AnglesOfTheAxesAreExact) {
    EXPECT_EQ(angle_of(0, 0), 0);
    EXPECT_EQ(angle_of(0, 2), 0);
    EXPECT_EQ(angle_of(3, 0), pi / 2);
    EXPECT_EQ(angle_of(0, -1), pi);
    EXPECT_EQ(angle_of(-1, 0), -pi / 2);
    EXPECT_EQ(angle_of(5, 5), pi / 4);
    EXPECT_EQ(angle_of(1e-300, -1e300), pi);
    EXPECT_EQ(arc_sine(-1), -pi / 2);
}

TEST(PortableMath, QuarterTurnsAreExact) {
    const double sines[] = {0, 1, 0, -1};
    for (int quarter = -9; quarter < 9; ++quarter) {
        EXPECT_EQ(sine(90 * quarter), sines[(quarter + 12) % 4]) << quarter;
        EXPECT_EQ(cosine(90 * quarter), sines[(quarter + 13) % 4]) << quarter;
    }
    EXPECT_EQ(sine(360e15), 0);
    EXPECT_TRUE(std::isnan(sine(INFINITY)));
}

TEST(PortableMath, ExponentialAndLogarithmAreInverse) {
    for (double x = -700; x < 700; x += 1.7) {
        EXPECT_NEAR(exponential(x) / std::exp(x), 1, 1e-14) << x;
        EXPECT_NEAR(logarithm(exponential(x)), x, 1e-13 * (1 + std::fabs(x))) << x;
    }
    EXPECT_EQ(exponential(0), 1);
    EXPECT_EQ(logarithm(1), 0);
    EXPECT_EQ(exponential(1e4), INFINITY);
    EXPECT_EQ(exponential(-1e4), 0);
    EXPECT_EQ(logarithm(0), -INFINITY);
    EXPECT_TRUE(std::isnan(logarithm(-1)));
    EXPECT_TRUE(std::isnan(exponential(NAN)));
}

TEST(PortableMath, WholePowersAreProducts) {
    EXPECT_EQ(power(0.5, 10), 1.0 / 1024);
    EXPECT_EQ(power(2, -3), 0.125);
    EXPECT_EQ(power(-3, 3), -27);
    EXPECT_EQ(power(0, 0), 1);
    EXPECT_EQ(power(0, 0.5), 0);
    EXPECT_TRUE(std::isnan(power(-1, 0.5)));
    for (double x = 0.1; x < 30; x *= 1.3) EXPECT_NEAR(power(x, 2.35) / std::pow(x, 2.35), 1, 1e-14);
}

TEST(PortableMath, ArcTangentFindsTheAngle) {
    for (double degrees = -179.5; degrees < 180; degrees += 0.7)
        EXPECT_NEAR(arc_tangent(3 * sine(degrees), 3 * cosine(degrees)), degrees, 1e-12);
    EXPECT_EQ(arc_tangent(0, 1), 0);
    EXPECT_EQ(arc_tangent(0, -1), 180);
    EXPECT_NEAR(arc_tangent(1, 0), 90, 1e-13);
}

}  // namespace
}  // namespace sinew::portable
