#include "sinew/sqm/surface/bisect.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sinew::sqm {
namespace {

TEST(Bisect, ClosesInOnWhereSomethingEnds) {
    const double root = std::sqrt(2.0);
    for (const int halvings : {0, 1, 5, 30}) {
        int asked = 0;
        const auto [inside, outside] = bisect(0, 2, halvings, [&](double x) { return ++asked, x < root; });
        EXPECT_EQ(asked, halvings);
        EXPECT_LT(inside, root);
        EXPECT_GE(outside, root);
        EXPECT_NEAR(outside - inside, std::ldexp(2.0, -halvings), 1e-15);
    }
}

TEST(Bisect, GoesEitherWay) {
    const auto [inside, outside] = bisect(2, 0, 20, [](double x) { return x > 0.25; });
    EXPECT_GT(inside, 0.25);
    EXPECT_LE(outside, 0.25);
    EXPECT_NEAR(inside, outside, 1e-5);
}

}  // namespace
}  // namespace sinew::sqm
