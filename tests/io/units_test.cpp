#include "sinew/io/units.h"

#include <gtest/gtest.h>

namespace sinew {
namespace {

TEST(Units, AreMultiplesOfEachOther) {
    EXPECT_EQ(metres_in("m"), 1);
    for (const auto& [larger, count, smaller] : {std::tuple("km", 1000, "m"),
                                                 {"m", 10, "dm"},
                                                 {"dm", 10, "cm"},
                                                 {"cm", 10, "mm"},
                                                 {"mm", 1000, "um"},
                                                 {"um", 1000, "nm"},
                                                 {"ft", 12, "in"},
                                                 {"in", 25400, "um"}})
        EXPECT_NEAR(*metres_in(larger) / *metres_in(smaller), count, 1e-9 * count) << larger;
}

TEST(Units, HaveLongNames) {
    for (const auto& [name, unit] : {std::pair("metre", "m"),
                                     {"meter", "m"},
                                     {"millimetre", "mm"},
                                     {"micron", "um"},
                                     {"\xC2\xB5m", "um"},
                                     {"\xCE\xBCm", "um"},
                                     {"micrometer", "um"},
                                     {"nanometre", "nm"},
                                     {"centimeter", "cm"},
                                     {"inch", "in"},
                                     {"foot", "ft"}})
        EXPECT_EQ(metres_in(name), metres_in(unit)) << name;
}

TEST(Units, OfOtherNamesAreUnknown) {
    for (const char* name : {"", "M", "parsec", "m ", "mm2"}) EXPECT_FALSE(metres_in(name)) << name;
}

}  // namespace
}  // namespace sinew
