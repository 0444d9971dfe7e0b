// Real skeletons: all sound ones load, the unsound ones are refused with their line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "shared_data.h"
#include "sinew/io/skeleton_formats.h"
#include "sinew/skeleton/graph.h"
#include "sinew/skeleton/validate.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> parts;
    std::istringstream stream(line);
    for (std::string part; std::getline(stream, part, '\t');) parts.push_back(part);
    return parts;
}

std::vector<std::vector<std::string>> table(const fs::path& path) {
    std::vector<std::vector<std::string>> rows;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) rows.push_back(cells(line));
    return rows;
}

class Corpus : public testing::Test {
  protected:
    void SetUp() override {
        if (data.empty()) GTEST_SKIP() << "the shared data is not here";
    }
    const fs::path data = shared_data();
};

TEST_F(Corpus, EveryGraphLoadsWithItsNodesCyclesAndComponents) {
    const auto index = table(data / "INDEX.tsv");
    std::map<std::string, std::size_t> column;
    for (std::size_t c = 0; c < index[0].size(); ++c) column[index[0][c]] = c;
    for (std::size_t r = 1; r < index.size(); ++r) {
        const auto& row = index[r];
        auto number = [&](const char* name) { return std::stoll(row[column.at(name)]); };
        SCOPED_TRACE(row[0]);
        Result<ReadSkeleton> read = read_skeleton((data / row[0]).string());
        ASSERT_TRUE(read) << read.error().text();
        const Document& document = read->document;
        EXPECT_TRUE(validate(document));
        const std::vector<Bone> bones = bones_of(document);
        EXPECT_EQ(std::ssize(document.nodes), number("nodes"));
        EXPECT_EQ(std::ssize(bones), number("edges") - number("duplicate_edges") - number("self_loops"));
        EXPECT_EQ(count_graph(static_cast<std::int32_t>(document.nodes.size()), bones).components,
                  number("components"));
    }
    EXPECT_EQ(index.size(), 203u);
}

TEST_F(Corpus, MalformedGraphsNameTheLineOfTheFirstNan) {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(data / "graph_malformed")) {
        std::ifstream file(entry.path());
        std::string text;
        std::int64_t line = 0;
        while (std::getline(file, text) && text.find("nan") == std::string::npos) ++line;
        Result<ReadSkeleton> read = read_skeleton(entry.path().string());
        ASSERT_FALSE(read) << entry.path();
        EXPECT_EQ(read.error().line, line + 1);
        EXPECT_EQ(read.error().file, entry.path().string());
        ++count;
    }
    EXPECT_EQ(count, 3);
}

/// What other projects' tests say of odd files. An error that only matters to neuroscience (several somata, a
/// soma below a neurite, types without a meaning) is none here.
TEST_F(Corpus, OddSwcFilesAreReadOrRefusedAsOthersDo) {
    int refused = 0;
    for (const char* project : {"MorphIO", "NeuroM"}) {
        const fs::path folder = data / "swc" / project;
        const auto rows = table(folder / "EXPECT.tsv");
        for (std::size_t r = 1; r < rows.size(); ++r) {
            const std::string& expected = rows[r][1];
            const std::string detail = rows[r].size() > 2 ? rows[r][2] : "";
            const bool error = expected == "error" && detail.find("Soma") == std::string::npos &&
                               detail.find("section type") == std::string::npos;
            Result<ReadSkeleton> read = read_skeleton((folder / rows[r][0]).string());
            EXPECT_EQ(!read, error) << rows[r][0] << ": " << (read ? detail : read.error().text());
            EXPECT_TRUE(read || read.error().line > 0) << rows[r][0];
            refused += !read;
        }
    }
    EXPECT_EQ(refused, 11);
}

TEST_F(Corpus, EverySoundSwcFileIsAValidTree) {
    int count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(data / "swc")) {
        if (entry.path().extension() != ".swc") continue;
        Result<ReadSkeleton> read = read_skeleton(entry.path().string());
        if (!read) continue;  // see above
        EXPECT_TRUE(validate(read->document)) << entry.path();
        ++count;
    }
    EXPECT_GT(count, 70);
}

}  // namespace
}  // namespace sinew
