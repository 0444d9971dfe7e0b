#include "files/recovery.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "document/delta.h"
#include "document/edits.h"
#include "sinew/io/files.h"
#include "sinew/io/skeleton_formats.h"
#include "temporary_folder.h"

namespace sinew::modeler {
namespace {

Document limb(int nodes) {
    Document document = starting_document();
    for (int i = 1; i < nodes; ++i)
        append_node(document, {.id = -1, .parent = i - 1, .position = Vec3(0, 0, i), .radius = 0.5});
    return document;
}

/// Another process keeps copies of documents and is killed in the midst of it.
void keep_and_be_killed(const std::filesystem::path& folder, const Document& document) {
    const pid_t child = fork();
    if (child == 0) {
        Recovery recovery(folder);
        const auto kept = recovery.keep(document, "/home/me/limb.sinew");
        if (kept) raise(SIGKILL);
        _exit(1);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
}

TEST(Recovery, what_a_killed_process_kept_is_there) {
    const TemporaryFolder folder;
    const Document document = limb(7);
    keep_and_be_killed(folder.path(), document);
    const Recovery recovery(folder.path());
    const std::vector<Leftover> leftovers = recovery.leftovers();
    ASSERT_EQ(leftovers.size(), 1u);
    EXPECT_EQ(leftovers[0].original, "/home/me/limb.sinew");
    const auto read = read_skeleton(leftovers[0].copy.string());
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_TRUE(same(read->document, document));
    Recovery::discard(leftovers[0]);
    EXPECT_TRUE(recovery.leftovers().empty());
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Recovery, the_newest_comes_first) {
    const TemporaryFolder folder;
    keep_and_be_killed(folder.path(), limb(2));
    const Recovery recovery(folder.path());
    const std::filesystem::path older = recovery.leftovers().at(0).copy;
    std::filesystem::last_write_time(older, std::filesystem::last_write_time(older) - std::chrono::hours(1));
    keep_and_be_killed(folder.path(), limb(3));
    const std::vector<Leftover> leftovers = recovery.leftovers();
    ASSERT_EQ(leftovers.size(), 2u);
    EXPECT_EQ(leftovers[1].copy, older);
}

TEST(Recovery, copies_of_what_still_runs_are_left_alone) {
    const TemporaryFolder folder;
    Recovery one(folder.path()), other(folder.path());
    EXPECT_NE(one.copy(), other.copy());  // two windows of one process
    ASSERT_TRUE(one.keep(limb(2), ""));
    EXPECT_TRUE(other.leftovers().empty());
    // The parent of this process runs as well.
    std::filesystem::copy_file(one.copy(), folder.path() / (std::to_string(getppid()) + "-0.sinew"));
    EXPECT_TRUE(other.leftovers().empty());
}

TEST(Recovery, nothing_is_left_where_all_went_well) {
    const TemporaryFolder folder;
    {
        Recovery recovery(folder.path());
        ASSERT_TRUE(recovery.keep(limb(2), "a"));
        ASSERT_TRUE(recovery.keep(limb(3), "b"));  // replaces the copy
        EXPECT_TRUE(std::filesystem::exists(recovery.copy()));
        recovery.drop();
        EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
        ASSERT_TRUE(recovery.keep(limb(4), "c"));
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Recovery, other_files_are_no_copies) {
    const TemporaryFolder folder;
    for (const char* name : {"notes.txt", "limb.sinew", "-3-0.sinew", "999999999.txt"})
        ASSERT_TRUE(write_file(folder.file(name), "x"));
    EXPECT_TRUE(Recovery(folder.path()).leftovers().empty());
}

TEST(Recovery, a_folder_that_cannot_be_is_an_error_of_keeping) {
    const TemporaryFolder folder;
    ASSERT_TRUE(write_file(folder.file("file"), "x"));
    Recovery recovery(folder.path() / "file" / "below");
    EXPECT_FALSE(recovery.keep(limb(2), ""));
    EXPECT_TRUE(recovery.leftovers().empty());
}

}  // namespace
}  // namespace sinew::modeler
