// A file may name others that lie beside or below it, and nothing else on the machine.
#include "sinew/io/named_files.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <filesystem>

#include "io/temporary_folder.h"
#include "sinew/io/files.h"

namespace sinew {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr std::uint64_t plenty = 1 << 20;

/// outside.bin beside the folder "model", in which a model and its data lie.
struct NamedFiles : testing::Test {
    TemporaryFolder folder;
    std::string model = folder / "model/a.gltf";

    NamedFiles() {
        std::filesystem::create_directories(folder.path() / "model/below");
        for (const char* name :
             {"outside.bin", "model/data.bin", "model/with space.bin", "model/below/data.bin"})
            EXPECT_TRUE(write_file(folder / name, std::string("bytes of ") + name));
    }
    std::string refusal(const std::string& reference) const {
        const auto read = read_named_file(model, reference, plenty);
        return read ? "" : read.error().text();
    }
};

TEST_F(NamedFiles, WhatLiesBesideOrBelowIsRead) {
    EXPECT_EQ(read_named_file(model, "data.bin", plenty).value(), "bytes of model/data.bin");
    EXPECT_EQ(read_named_file(model, "./below/data.bin", plenty).value(), "bytes of model/below/data.bin");
    EXPECT_EQ(read_named_file(model, "with%20space.bin", plenty).value(), "bytes of model/with space.bin");
}

TEST_F(NamedFiles, NoWayOfWritingLeadsOutOfTheFolder) {
    const std::string outside = folder / "outside.bin";
    for (const std::string& reference :
         {outside, "file://" + outside, "file:" + outside, std::string("../outside.bin"),
          std::string("%2e%2e/outside.bin"), std::string("below/../../outside.bin"),
          std::string("..%2foutside.bin"), "%2f" + outside.substr(1), std::string("http://a/b.bin"),
          std::string(""), std::string("."), std::string("data.bin%00"), std::string("data.bin%")})
        EXPECT_THAT(refusal(reference), HasSubstr("a.gltf: names the file '")) << reference;
}

TEST_F(NamedFiles, LinksCountByWhereTheyLead) {
    std::filesystem::create_symlink(folder / "outside.bin", folder / "model/out.bin");
    std::filesystem::create_directory_symlink(folder.path(), folder / "model/up");
    std::filesystem::create_symlink("below/data.bin", folder / "model/in.bin");
    EXPECT_EQ(read_named_file(model, "in.bin", plenty).value(), "bytes of model/below/data.bin");
    EXPECT_THAT(refusal("out.bin"), HasSubstr("a link that leads out of it"));
    EXPECT_THAT(refusal("up/outside.bin"), HasSubstr("a link that leads out of it"));
}

TEST_F(NamedFiles, AMessageDoesNotTellWhatExistsElsewhere) {
    std::filesystem::create_symlink(folder / "outside.bin", folder / "model/to.bin");
    std::string there = refusal("to.bin");
    std::filesystem::remove(folder / "outside.bin");
    EXPECT_EQ(there, refusal("to.bin"));
}

TEST_F(NamedFiles, OnlyRegularFilesOfTheStatedSize) {
    ASSERT_EQ(mkfifo((folder / "model/pipe.bin").c_str(), 0600), 0);
    EXPECT_THAT(refusal("pipe.bin"), HasSubstr("no regular file")) << "and nobody waits for who writes to it";
    EXPECT_THAT(refusal("below"), HasSubstr("no regular file"));
    const std::size_t size = std::string("bytes of model/data.bin").size();
    EXPECT_TRUE(read_named_file(model, "data.bin", size));
    const auto larger = read_named_file(model, "data.bin", size - 1);
    ASSERT_FALSE(larger);
    EXPECT_THAT(larger.error().text(), HasSubstr("has more than 22 bytes"));
}

TEST_F(NamedFiles, StandardInputNamesNothing) {
    for (const std::string name : {"-", "standard input", ""})
        EXPECT_THAT(read_named_file(name, "data.bin", plenty).error().text(), HasSubstr("standard input"));
}

TEST_F(NamedFiles, AFileWithoutFolderMeansTheOneWhereOneStands) {
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path() / "model");
    EXPECT_TRUE(read_named_file("a.gltf", "data.bin", plenty));
    EXPECT_FALSE(read_named_file("a.gltf", folder / "outside.bin", plenty));
    std::filesystem::current_path(before);
}

}  // namespace
}  // namespace sinew
