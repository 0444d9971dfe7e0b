#include "sinew/base/large_array.h"

#include <gtest/gtest.h>

namespace sinew {
namespace {

TEST(LargeArray, IsAVectorLikeAnyOther) {
    for (const std::size_t count : {0u, 3u, 1'000'000u, 5'000'001u}) {
        std::vector<int> array{7};
        resize_large(array, count, 5);
        ASSERT_EQ(array.size(), count);
        if (count == 0) continue;
        EXPECT_EQ(array.front(), 7);  // what was there stays
        EXPECT_EQ(array.back(), 5);
    }
}

}  // namespace
}  // namespace sinew
