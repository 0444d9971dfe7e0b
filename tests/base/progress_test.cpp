#include "sinew/base/progress.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace sinew {
namespace {

TEST(Progress, OfNobodyReportsToNobodyAndNeverStops) {
    const Progress progress;
    progress(0.5, "refine");
    EXPECT_FALSE(progress.cancelled());
}

TEST(Progress, CopiesReportToTheSameListenerAndStopTogether) {
    std::string heard;
    std::atomic<bool> stop{false};
    const Progress progress(
        [&](double share, std::string_view stage) { heard = std::string(stage) + (share == 0.5 ? "!" : ""); },
        &stop);
    const Progress copy = progress;
    copy(0.5, "bridge");
    EXPECT_EQ(heard, "bridge!");
    EXPECT_FALSE(copy.cancelled());
    std::thread([&] { stop = true; }).join();
    EXPECT_TRUE(copy.cancelled());
    EXPECT_TRUE(progress.cancelled());
    EXPECT_EQ(Progress::stopped().value().kind, ErrorKind::cancelled);
}

TEST(Progress, OfAPartRunsWithinThatOfTheWhole) {
    std::vector<double> shares;
    const std::atomic<bool> stop = true;
    const Progress whole([&](double share, std::string_view) { shares.push_back(share); }, &stop);
    const Progress part = whole.part(0.5, 0.75);
    for (const double share : {0.0, 0.5, 1.0}) part(share, "stage");
    part.part(0, 0.5)(1, "stage");
    EXPECT_EQ(shares, (std::vector{0.5, 0.625, 0.75, 0.625}));
    EXPECT_TRUE(part.cancelled());
    EXPECT_TRUE(Progress({}, &stop).part(0, 1).cancelled());
    Progress().part(0, 1)(0.5, "to nobody");
}

}  // namespace
}  // namespace sinew
