#include "sinew/io/swc_soma.h"

#include <gtest/gtest.h>

namespace sinew {
namespace {

/// Soma samples on a circle, each the child of the one before it.
/// @param share  of the circle that they go round
std::vector<SwcSample> contour(std::size_t count, double circle, double thickness, double share = 1) {
    std::vector<SwcSample> samples;
    for (std::size_t i = 0; i < count; ++i) {
        const double a = 2 * M_PI * share * double(i) / double(count);
        samples.push_back({.id = std::int64_t(i),
                           .type = 1,
                           .parent = std::int32_t(i) - 1,
                           .position = Vec3(5 + circle * std::cos(a), circle * std::sin(a), 2),
                           .radius = thickness});
    }
    return samples;
}

std::size_t gone(std::vector<SwcSample>& samples) {
    Remarks remarks;
    std::size_t count = 0;
    for (const char one : fold_somata(samples, remarks)) count += one != 0;
    return count;
}

std::vector<SwcSample> three_point(double away, double radius) {
    return {{.id = 1, .type = 1, .parent = -1, .position = Vec3(0, 0, 0), .radius = 2},
            {.id = 2, .type = 1, .parent = 0, .position = Vec3(0, away, 0), .radius = radius},
            {.id = 3, .type = 1, .parent = 0, .position = Vec3(0, -away, 0), .radius = radius}};
}

TEST(SwcSoma, AClosedContourIsTheSphereOfItsMean) {
    for (const std::size_t count : {4, 5, 12}) {
        auto samples = contour(count, 3, 0.1);
        EXPECT_EQ(gone(samples), count - 1);
        EXPECT_LT((samples[0].position - Vec3(5, 0, 2)).norm(), 1e-12);
        EXPECT_NEAR(samples[0].radius, 3, 1e-12);
    }
}

TEST(SwcSoma, WhatIsLeftHangsFromTheRoot) {
    auto samples = contour(6, 3, 0.1);
    samples.push_back({.id = 9, .type = 3, .parent = 4, .position = Vec3(9, 0, 2), .radius = 0.2});
    samples.push_back({.id = 10, .type = 3, .parent = 6, .position = Vec3(12, 0, 2), .radius = 0.2});
    gone(samples);
    EXPECT_EQ(samples[6].parent, 0);
    EXPECT_EQ(samples[7].parent, 6);
}

TEST(SwcSoma, NoContourAreThreeSamplesAnOpenArcOrAThickChain) {
    auto three = contour(3, 3, 0.1), arc = contour(12, 3, 0.1, 0.7), thick = contour(12, 3, 1.6);
    EXPECT_EQ(gone(three), 0u);
    EXPECT_EQ(gone(arc), 0u) << "the gap is larger than two steps";
    EXPECT_EQ(gone(thick), 0u) << "the circle is not twice as wide as the samples";
    auto thin = contour(12, 3, 1.4);
    EXPECT_EQ(gone(thin), 11u);
}

TEST(SwcSoma, NoContourIsAChainThatDoublesBack) {
    auto samples = contour(6, 3, 0.1);
    for (std::size_t i = 0; i < 6; ++i) samples[i].position = Vec3(i < 3 ? double(i) : 5.0 - double(i), 0, 0);
    EXPECT_EQ(gone(samples), 0u) << "samples at the middle of it";
}

TEST(SwcSoma, OnlySamplesOfASomaFromItsRootAreFolded) {
    auto dendrite = contour(6, 3, 0.1);
    for (SwcSample& sample : dendrite) sample.type = 3;
    EXPECT_EQ(gone(dendrite), 0u);
    auto forks = contour(6, 3, 0.1);
    forks[5].parent = 3;
    EXPECT_EQ(gone(forks), 0u);
}

TEST(SwcSoma, ThreePointsStandOppositeAtTheRadiusToOnePercent) {
    for (const auto& [away, radius, folded] : {std::tuple(2.0, 2.0, true),
                                               {2.019, 2.0, true},
                                               {2.021, 2.0, false},
                                               {2.0, 1.981, true},
                                               {2.0, 1.979, false},
                                               {2.0, 0.0, true}}) {
        auto samples = three_point(away, radius);
        EXPECT_EQ(gone(samples), folded ? 2u : 0u) << away << " " << radius;
        EXPECT_EQ(samples[0].radius, 2);
    }
    auto askew = three_point(2, 2);
    askew[2].position = Vec3(2, 0, 0);
    EXPECT_EQ(gone(askew), 0u) << "not opposite";
    auto longer = three_point(2, 2);
    longer.push_back({.id = 4, .type = 1, .parent = 2, .position = Vec3(0, -3, 0), .radius = 2});
    EXPECT_EQ(gone(longer), 0u) << "a chain goes on";
}

}  // namespace
}  // namespace sinew
