#include "sinew/sqm/fit/round_end.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace sinew::sqm {
namespace {

/// A round end as the mesher hands it over: rings evenly over the ball, two below on the cone.
struct End {
    double sine = 0;
    std::vector<ProfileRow> rows;
    ProfileRow below[2];
};
End round_end(int rings, double sine, double first_gap, double second_gap) {
    End end{.sine = sine, .rows = {{1, 0}}, .below = {}};
    const double touch = std::asin(sine), cosine = std::cos(touch);
    for (int i = rings - 1; i >= 0; --i) {
        const double angle = touch + (std::numbers::pi / 2 - touch) * i / rings;
        end.rows.push_back({std::sin(angle), std::cos(angle)});
    }
    const auto lower = [&](const ProfileRow& row, double gap) -> ProfileRow {
        return {row.height - gap * cosine, row.radius + gap * sine};
    };
    end.below[0] = lower(end.rows.back(), first_gap);
    end.below[1] = lower(end.below[0], second_gap);
    return end;
}

/// The cubic B-spline of a profile, from the pole to the first row below.
std::vector<ProfileRow> smooth_profile(const End& end) {
    std::vector<ProfileRow> control{{end.rows[1].height, -end.rows[1].radius}}, smooth;
    control.insert(control.end(), end.rows.begin(), end.rows.end());
    control.insert(control.end(), {end.below[0], end.below[1]});
    constexpr int pieces = 40;
    for (std::size_t i = 0; i + 3 < control.size(); ++i)
        for (int piece = 0; piece <= pieces; ++piece) {
            const double t = double(piece) / pieces, s = 1 - t;
            const std::array weights{s * s * s / 6, (3 * t * t * t - 6 * t * t + 4) / 6,
                                     (3 * s * s * s - 6 * s * s + 4) / 6, t * t * t / 6};
            ProfileRow point;
            for (std::size_t j = 0; j < 4; ++j) {
                point.height += weights[j] * control[i + j].height;
                point.radius += weights[j] * control[i + j].radius;
            }
            smooth.push_back(point);
        }
    return smooth;
}

double worst_distance(const End& end) {
    double worst = 0;
    const double cosine = std::sqrt(1 - end.sine * end.sine);
    for (const auto& [height, radius] : smooth_profile(end)) {
        const bool on_cone = height * cosine < radius * end.sine;
        const double distance = on_cone ? height * end.sine + radius * cosine - 1
                                        : std::sqrt(height * height + radius * radius) - 1;
        worst = std::max(worst, std::abs(distance));
    }
    return worst;
}

TEST(RoundEnd, IsTheBallAndTheConeBelow) {
    const double most[] = {0.03, 0.017, 0.01, 0.0065, 0.005, 0.004, 0.003, 0.0025};  // of 1, 2, .. rings
    for (int rings = 1; rings <= int(most_round_rings); ++rings)
        for (const double sine : {-0.6, -0.3, 0.0, 0.02, 0.3, 0.6})
            for (const double gap : {0.4, 0.5, 0.8}) {
                SCOPED_TRACE(testing::Message() << rings << " rings, sine " << sine << ", gap " << gap);
                End end = round_end(rings, sine, gap, gap);
                const double before = worst_distance(end);
                fit_round_end(end.sine, end.rows, end.below);
                EXPECT_LT(worst_distance(end), most[rings - 1]);
                EXPECT_LT(worst_distance(end), before);
                EXPECT_EQ(end.rows[0].radius, 0);
            }
}

/// What is a hair's breadth different is fitted alike: there is no step at which the search ends early.
TEST(RoundEnd, ChangesAsItsShapeDoes) {
    for (const int rings : {1, 2, 3, 5})
        for (const double sine : {-0.3, 0.1, 0.5}) {
            End end = round_end(rings, sine, 0.5, 0.6),
                other = round_end(rings, sine + 1e-7, 0.5 + 1e-7, 0.6);
            fit_round_end(end.sine, end.rows, end.below);
            fit_round_end(other.sine, other.rows, other.below);
            for (int i = 0; i <= rings; ++i) {
                EXPECT_NEAR(end.rows[i].height, other.rows[i].height, 1e-5);
                EXPECT_NEAR(end.rows[i].radius, other.rows[i].radius, 1e-5);
            }
        }
}

TEST(RoundEnd, IsLeftWhereTheRowsBelowAreNoContinuation) {
    End end = round_end(2, 0, 0.5, 0.5);
    end.below[0] = {3, 1};  // above the pole
    const std::vector<ProfileRow> before = end.rows;
    fit_round_end(end.sine, end.rows, end.below);
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_EQ(end.rows[i].height, before[i].height);
        EXPECT_EQ(end.rows[i].radius, before[i].radius);
    }
}

}  // namespace
}  // namespace sinew::sqm
