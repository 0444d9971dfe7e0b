#include "sinew/render/egl_context.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace sinew {
namespace {

bool names_packages(const Error& error) {
    return error.kind == ErrorKind::program && error.cure.find("libegl1") != std::string::npos &&
           error.cure.find("libgl1-mesa-dri") != std::string::npos;
}

TEST(EglContext, NeedsNoDisplay) {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    const auto context = EglContext::create();
    EXPECT_TRUE(context) << context.error().text();
}

TEST(EglContext, WithoutEglSaysWhatToInstall) {
    const auto context = EglContext::create("libEGL_that_is_not_there.so.1");
    ASSERT_FALSE(context);
    EXPECT_TRUE(names_packages(context.error())) << context.error().text();
}

/// In a process of its own, for Mesa looks for its drivers once.
TEST(EglContextDeathTest, WithoutADriverSaysWhatToInstall) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    const auto without_driver = [] {
        setenv("LIBGL_DRIVERS_PATH", "/nowhere", 1);
        setenv("GBM_BACKENDS_PATH", "/nowhere", 1);
        const auto context = EglContext::create();
        std::exit(!context && names_packages(context.error()) ? 0 : 1);
    };
    EXPECT_EXIT(without_driver(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace sinew
