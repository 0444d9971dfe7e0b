#include "sinew/base/progress.h"

#include <gtest/gtest.h>

#include <thread>

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

}  // namespace
}  // namespace sinew
