#include "sinew/grow/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sinew::lsystem {
namespace {

TEST(Random, IsSplitMix64) {  // values that its authors' program prints for the seed 1234567
    const std::uint64_t published[] = {6457827717110365317u, 3203168211198807973u, 9817491932198370423u};
    Random random(1234567);
    for (std::uint64_t value : published)
        EXPECT_EQ(random.uniform(), static_cast<double>(value >> 11) * 0x1p-53);
}

TEST(Random, HasTheMomentsOfItsDistributions) {
    Random random(3);
    constexpr int n = 100000;
    double sum = 0, normal_sum = 0, normal_squares = 0;
    for (int i = 0; i < n; ++i) {
        const double u = random.uniform(2, 4);
        ASSERT_GE(u, 2);
        ASSERT_LT(u, 4);
        sum += u;
        const double z = random.normal(1, 2);
        normal_sum += z;
        normal_squares += (z - 1) * (z - 1);
    }
    EXPECT_NEAR(sum / n, 3, 0.01);
    EXPECT_NEAR(normal_sum / n, 1, 0.03);
    EXPECT_NEAR(std::sqrt(normal_squares / n), 2, 0.03);
}

TEST(Random, ChildrenDifferFromEachOtherAndFromTheirParent) {
    EXPECT_NE(child_key(1, 0), child_key(1, 1));
    EXPECT_NE(child_key(1, 0), child_key(2, 0));
    EXPECT_NE(child_key(child_key(1, 0), 1), child_key(child_key(1, 1), 0));
}

}  // namespace
}  // namespace sinew::lsystem
