// Files are read whole and replaced whole: whatever fails, the old file stays and nothing else is left beside
// it.
#include "sinew/io/files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
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
    EXPECT_EQ(written.error().kind, ErrorKind::call) << "who calls makes room";
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

TEST(Files, WhatIsOpenAlreadyIsWrittenWhereItStands) {
    TemporaryFolder folder;
    const std::string path = folder / "log";
    ASSERT_TRUE(write_file(path, "before\n"));
    const int log = open(path.c_str(), O_WRONLY | O_APPEND);
    for (const char* name : {"/dev/fd/{}", "/proc/self/fd/{}"})
        EXPECT_TRUE(write_file(fmt::format(fmt::runtime(name), log), "added\n")) << name;
    close(log);
    EXPECT_EQ(read_file(path).value(), "before\nadded\nadded\n");
    EXPECT_FALSE(write_file(fmt::format("/dev/fd/{}", log), "x")) << "it is closed now";
}

TEST(Files, AHardLinkStaysOne) {
    TemporaryFolder folder;
    ASSERT_TRUE(write_file(folder / "one", "old and long"));
    std::filesystem::create_hard_link(folder / "one", folder / "two");
    for (const std::string text : {"new", "newer and longer than before"}) {
        ASSERT_TRUE(write_file(folder / "one", text));
        EXPECT_EQ(read_file(folder / "two").value(), text);
    }
    EXPECT_THAT(entries(folder.path()), testing::UnorderedElementsAre("one", "two"));
}

TEST(Files, ACircleOfLinksIsAnError) {
    TemporaryFolder folder;
    std::filesystem::create_symlink("b", folder / "a");
    std::filesystem::create_symlink("a", folder / "b");
    const auto written = write_file(folder / "a", "x");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().kind, ErrorKind::call);
    EXPECT_THAT(written.error().text(), HasSubstr("circle"));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "a"));
}

TEST(Files, WhatAKilledProgramLeftIsCleanedUp) {
    TemporaryFolder folder;
    std::ofstream(folder / ".a.obj.part") << "half";
    ASSERT_TRUE(write_file(folder / "a.obj", "whole"));
    EXPECT_EQ(read_file(folder / "a.obj").value(), "whole");
    EXPECT_THAT(entries(folder.path()), testing::ElementsAre("a.obj"));
}

TEST(Files, WhatAnotherIsWritingIsLeftAlone) {
    TemporaryFolder folder;
    std::ofstream(folder / ".a.obj.part") << "half";
    const int other = open((folder / ".a.obj.part").c_str(), O_RDONLY);
    ASSERT_EQ(flock(other, LOCK_EX), 0);
    ASSERT_TRUE(write_file(folder / "a.obj", "whole"));
    EXPECT_THAT(entries(folder.path()), testing::UnorderedElementsAre("a.obj", ".a.obj.part"));
    close(other);
}

TEST(Files, TheRightToRunAsSomebodyElseIsNotKept) {
    TemporaryFolder folder;
    for (const bool linked : {false, true}) {
        const std::string path = folder / (linked ? "linked" : "alone");
        ASSERT_TRUE(write_file(path, "old"));
        if (linked) std::filesystem::create_hard_link(path, folder / "other name");
        ASSERT_EQ(chmod(path.c_str(), 06755), 0);
        ASSERT_TRUE(write_file(path, "new"));
        EXPECT_EQ(std::filesystem::status(path).permissions(), std::filesystem::perms(0755));
    }
}

TEST(Files, ANameThatIsTooLongIsTheCallsFault) {
    TemporaryFolder folder;
    const auto written = write_file(folder / std::string(300, 'a'), "x");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().kind, ErrorKind::call);
    EXPECT_THAT(written.error().text(), HasSubstr("take a shorter name"));
}

TEST(Files, DevicesAreNoInput) {
    EXPECT_THAT(read_file("/dev/zero").error().text(), HasSubstr("/dev/zero: is a device, not a file"));
    EXPECT_EQ(read_file("/dev/null").value(), "");
}

TEST(Files, AnInputHasACap) {
    TemporaryFolder folder;
    ASSERT_TRUE(write_file(folder / "large", ""));
    std::filesystem::resize_file(folder / "large", largest_input + 1);  // of holes
    EXPECT_THAT(read_file(folder / "large").error().text(), HasSubstr("has more than 2147483648 bytes"));
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    ASSERT_EQ(write(ends[1], "12345", 5), 5);
    close(ends[1]);
    EXPECT_FALSE(read_descriptor(ends[0], 4)) << "a pipe does not say how much is in it";
    close(ends[0]);
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
