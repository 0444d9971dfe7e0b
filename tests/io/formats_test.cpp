#include "sinew/io/formats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace sinew {
namespace {

using testing::HasSubstr;

TEST(Formats, NamesAndExtensionsAreUnique) {
    std::set<std::string_view> names, extensions;
    for (const Format& format : formats()) {
        EXPECT_TRUE(names.insert(format.name).second) << format.name;
        EXPECT_TRUE(extensions.insert(format.extension).second) << format.extension;
        EXPECT_TRUE(format.reads_skeleton || format.writes_skeleton || format.reads_mesh ||
                    format.writes_mesh);
    }
}

TEST(Formats, AreChosenByExtensionOrByName) {
    EXPECT_EQ(choose_format("x/A.SWC", "", FormatUse::read_skeleton).value()->id, FormatName::swc);
    EXPECT_EQ(choose_format("-", "graph", FormatUse::read_skeleton).value()->id, FormatName::graph);
    EXPECT_EQ(choose_format("a.txt", "sinew", FormatUse::write_skeleton).value()->id, FormatName::sinew);
}

TEST(Formats, AWrongChoiceNamesTheRightOnes) {
    auto error = [](const char* path, const char* name, FormatUse use) {
        return choose_format(path, name, use).error();
    };
    EXPECT_THAT(error("-", "", FormatUse::read_skeleton).text(), HasSubstr("sinew, graph, swc, gltf, glb"));
    EXPECT_THAT(error("a.docx", "", FormatUse::write_mesh).text(), HasSubstr("obj, ply, stl, usda"));
    EXPECT_THAT(error("a.stl", "", FormatUse::read_mesh).text(), HasSubstr("'stl' cannot be read as a mesh"));
    EXPECT_THAT(error("a.stl", "mesh", FormatUse::read_mesh).text(), HasSubstr("no format 'mesh'"));
    EXPECT_EQ(error("-", "", FormatUse::read_mesh).kind, ErrorKind::call);
}

TEST(Formats, TheTableIsALineAFormat) {
    const std::string text = formats_text();
    EXPECT_EQ(std::ssize(formats()) + 1, std::count(text.begin(), text.end(), '\n'));
}

}  // namespace
}  // namespace sinew
