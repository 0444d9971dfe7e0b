#include "sinew/extend/automorphism.h"

#include <gtest/gtest.h>

namespace sinew {
namespace {

TEST(BonesFollow, InAnyOrderAndFromEitherEnd) {
    const std::vector<Bone> path{{0, 1}, {1, 2}, {2, 3}};
    EXPECT_TRUE(bones_follow(path, {0, 1, 2, 3}));
    EXPECT_TRUE(bones_follow(path, {3, 2, 1, 0}));
    EXPECT_TRUE(bones_follow({{1, 0}, {3, 2}, {1, 2}}, {3, 2, 1, 0}));
    EXPECT_TRUE(bones_follow({}, {1, 0}));
}

TEST(BonesFollow, NotWhereAnImageIsNoBone) {
    EXPECT_FALSE(bones_follow({{0, 1}, {1, 2}, {2, 3}}, {1, 0, 2, 3}));
    EXPECT_FALSE(bones_follow({{0, 1}}, {0, 2, 1}));
    EXPECT_FALSE(bones_follow({{0, 1}, {2, 3}}, {0, 1, 0, 1})) << "both go to one";
}

}  // namespace
}  // namespace sinew
