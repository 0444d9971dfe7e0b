// Files are read whole and replaced whole: whatever fails, the old file stays and nothing else is left beside
// it.
#include "sinew/io/files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "io/temporary_folder.h"

namespace sinew {
namespace {

using testing::HasSubstr;

std::vector<std::string> entries(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        names.push_back(entry.path().filename());
    return names;
}

TEST(Files, WhatIsWrittenIsReadBack) {
    TemporaryFolder folder;
    const std::string path = folder / "a.sinew";
    const std::string bytes("zero \0 and \xff, \r\n", 15);
    ASSERT_TRUE(write_file(path, bytes));
    EXPECT_EQ(read_file(path).value(), bytes);
    ASSERT_TRUE(write_file(path, ""));
    EXPECT_EQ(read_file(path).value(), "");
    EXPECT_THAT(entries(folder.path()), testing::ElementsAre("a.sinew"));
}

TEST(Files, WhatDoesNotKnowItsSizeIsReadToItsEnd) {
    const std::string path = "/proc/cpuinfo";  // of size 0, as the file system has it
    std::ifstream stream(path);
    if (!stream) GTEST_SKIP() << "there is no " << path;
    const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    ASSERT_GT(text.size(), 1u);
    EXPECT_EQ(lines(read_file(path).value()), lines(text));
}

TEST(Files, AFileLimitLeavesTheOldFileWhole) {
    TemporaryFolder folder;
    const std::string path = folder / "old.obj";
    ASSERT_TRUE(write_file(path, "old"));
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit small = before;
    small.rlim_cur = 4096;
    setrlimit(RLIMIT_FSIZE, &small);
    Result<void> written = write_file(path, std::string(100000, 'x'));
    setrlimit(RLIMIT_FSIZE, &before);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().kind, ErrorKind::program);
    EXPECT_THAT(written.error().text(), HasSubstr("the old file is as it was"));
    EXPECT_EQ(read_file(path).value(), "old");
    EXPECT_THAT(entries(folder.path()), testing::ElementsAre("old.obj"));
}

TEST(Files, AFullDeviceIsAnError) {
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    Result<void> written = write_file("/dev/full", "x");
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().text(), HasSubstr("/dev/full: cannot be written (No space left on device)"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));  // and not replaced by a file
}

TEST(Files, DevicesAreWrittenToAndStay) {
    ASSERT_TRUE(write_file("/dev/null", "x"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(Files, AReadOnlyFolderIsAnError) {
    TemporaryFolder folder;
    const std::string path = folder / "old.obj";
    ASSERT_TRUE(write_file(path, "old"));
    std::filesystem::permissions(folder.path(), std::filesystem::perms(0555));
    const bool was_root = geteuid() == 0;  // whom permissions do not stop
    ASSERT_TRUE(!was_root || seteuid(65534) == 0);
    Result<void> written = write_file(path, "new");
    ASSERT_TRUE(!was_root || seteuid(0) == 0);
    std::filesystem::permissions(folder.path(), std::filesystem::perms(0755));
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().text(), HasSubstr("check the permissions"));
    EXPECT_EQ(read_file(path).value(), "old");
    EXPECT_THAT(entries(folder.path()), testing::ElementsAre("old.obj"));
}

TEST(Files, AMissingFolderIsTheCallsFault) {
    TemporaryFolder folder;
    Result<void> written = write_file(folder / "none/a.obj", "x");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().kind, ErrorKind::call);
    EXPECT_THAT(written.error().text(), HasSubstr("make the folder first"));
    written = write_file(folder.path().string(), "x");
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().text(), HasSubstr("name a file, not a folder"));
}

TEST(Files, LinksAndPermissionsStay) {
    TemporaryFolder folder;
    const std::string path = folder / "real.txt";
    ASSERT_TRUE(write_file(path, "old"));
    std::filesystem::permissions(path, std::filesystem::perms(0640));
    std::filesystem::create_symlink("real.txt", folder / "link.txt");
    std::filesystem::create_symlink("fresh.txt", folder / "dangling.txt");
    ASSERT_TRUE(write_file(folder / "link.txt", "new"));
    ASSERT_TRUE(write_file(folder / "dangling.txt", "made"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
    EXPECT_EQ(read_file(path).value(), "new");
    EXPECT_EQ(std::filesystem::status(path).permissions(), std::filesystem::perms(0640));
    EXPECT_EQ(read_file(folder / "fresh.txt").value(), "made");
}

TEST(Files, WhatCannotBeReadIsNamed) {
    TemporaryFolder folder;
    EXPECT_THAT(read_file(folder / "none.swc").error().text(),
                HasSubstr("none.swc: cannot be opened (No such file or directory); check the name"));
    EXPECT_THAT(read_file(folder.path().string()).error().text(), HasSubstr("name a file, not a folder"));
}

TEST(Files, Extensions) {
    EXPECT_EQ(extension_of("a/b.c/Neuron.SWC"), ".swc");
    EXPECT_EQ(extension_of("a.b/plain"), "");
    EXPECT_EQ(extension_of("-"), "");
}

}  // namespace
}  // namespace sinew
