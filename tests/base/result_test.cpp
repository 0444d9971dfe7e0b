#include "sinew/base/result.h"

#include <gtest/gtest.h>

namespace sinew {
namespace {

TEST(Error, SaysEverythingThatIsKnownInOneLine) {
    Error error{.message = "the radius is 0", .cure = "give a positive one"};
    EXPECT_EQ(error.text(), "the radius is 0; give a positive one");
    error.file = "hand.sinew";
    EXPECT_EQ(error.text(), "hand.sinew: the radius is 0; give a positive one");
    error.line = 3;
    error.column = 14;
    error.path = "/nodes/2/radius";
    error.node = 7;
    EXPECT_EQ(error.text(), "hand.sinew:3:14: /nodes/2/radius: node 7: the radius is 0; give a positive one");
}

TEST(Result, HoldsAValueOrAnError) {
    const auto half = [](int number) -> Result<int> {
        if (number % 2 != 0) return fail(ErrorKind::call, "the number is odd");
        return number / 2;
    };
    ASSERT_TRUE(half(4));
    EXPECT_EQ(*half(4), 2);
    ASSERT_FALSE(half(3));
    EXPECT_EQ(half(3).error().kind, ErrorKind::call);
    EXPECT_EQ(half(3).error().text(), "the number is odd");
}

}  // namespace
}  // namespace sinew
