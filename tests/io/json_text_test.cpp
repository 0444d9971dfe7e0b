#include "sinew/io/json_text.h"

#include <gtest/gtest.h>

namespace sinew {
namespace {

TEST(JsonText, IntegersMayBeWrittenWithAPointUpToTwoToThe53) {
    EXPECT_EQ(integer_in(Json(7)), 7);
    EXPECT_EQ(integer_in(Json(-7.0)), -7);
    EXPECT_EQ(integer_in(Json(9007199254740992.0)), std::int64_t{1} << 53);
    for (const Json& none : {Json(9007199254740994.0), Json(1e300), Json(0.5), Json("7"), Json(true), Json(),
                             Json(std::uint64_t{1} << 63)})
        EXPECT_FALSE(integer_in(none)) << none;
    EXPECT_EQ(integer_in(Json(INT64_MAX)), INT64_MAX) << "as an integer all 64 bits";
}

TEST(JsonText, StepsOfPointersAreEscaped) {
    EXPECT_EQ(pointer_step("a/b"), "a~1b");
    EXPECT_EQ(pointer_step("~1"), "~01");
}

TEST(JsonText, LinesAreThoseWhereAValueStarts) {
    const std::string text = "{\n \"a\": [\n  1,\n  {\"b/c\":\n 2}\n ]\n}";
    EXPECT_EQ(line_of(text, ""), 1);
    EXPECT_EQ(line_of(text, "/a"), 2);
    EXPECT_EQ(line_of(text, "/a/0"), 3);
    EXPECT_EQ(line_of(text, "/a/1/b~1c"), 5);
    EXPECT_EQ(line_of(text, "/a/1/other"), 4) << "the innermost that exists";
}

}  // namespace
}  // namespace sinew
