// Every file of examples/lsystems grows, and none of its beginnings does harm; the manual speaks the truth.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "grow/grow_testing.h"
#include "sinew/grow/turtle_symbols.h"

namespace sinew {
namespace {

std::vector<std::filesystem::path> examples() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(SINEW_EXAMPLES))
        if (entry.path().extension() == ".lsys") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::string content(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

TEST(Examples, Grow) {
    EXPECT_GE(examples().size(), 12u);
    for (const auto& path : examples()) {
        SCOPED_TRACE(path.filename());
        const Document document = sinew::testing::grown(content(path));
        EXPECT_GT(document.nodes.size(), 10u);
        EXPECT_LT(document.nodes.size(), 20000u);
    }
}

TEST(Examples, SayWhatTheirConstantsMean) {
    for (const auto& path : examples())
        for (const GrowConstant& constant : sinew::testing::parsed(content(path)).constants)
            EXPECT_FALSE(constant.remark.empty()) << path << " " << constant.name;
}

TEST(Examples, EveryPrefixGrowsOrSaysWhere) {
    for (const auto& path : examples()) {
        const std::string text = content(path);
        for (std::size_t length = 0; length < text.size(); ++length) {
            const std::string prefix = text.substr(0, length);
            const auto grammar = parse_grammar(prefix, "prefix");
            if (grammar) {
                (void)grow(*grammar, {.steps = 3, .limit = 2000});
                continue;
            }
            const Error& error = grammar.error();
            const auto lines = std::count(prefix.begin(), prefix.end(), '\n') + 1;
            EXPECT_EQ(error.file, "prefix");
            EXPECT_TRUE(error.line >= 1 && error.line <= lines) << error.text();
            EXPECT_TRUE(error.column >= 1 && error.column <= static_cast<std::int64_t>(length) + 1)
                << error.text();
        }
    }
}

/// The first block of indented lines after a line.
std::string block_after(const std::string& text, const std::string& line) {
    std::stringstream rest(text.substr(text.find(line) + line.size()));
    std::string block;
    for (std::string one; std::getline(rest, one);) {
        if (!one.empty() && one[0] != ' ') break;
        block += one.size() > 4 ? one.substr(4) + "\n" : "\n";
    }
    return block;
}

TEST(Manual, ShowsAnExampleThatGrows) {
    const std::string manual = content(SINEW_MANUAL);
    std::string tree = block_after(manual, "## A first tree\n");
    EXPECT_EQ(sinew::testing::grown(tree).nodes.size(), 128u);
    tree.replace(tree.find("+(spread"), 8, "+(spraed");
    const std::string error = parse_grammar(tree.substr(1), "tree.lsys").error().text();
    EXPECT_NE(manual.find(error), std::string::npos) << error;
}

TEST(Manual, ExplainsEverySymbol) {
    const std::string manual = content(SINEW_MANUAL);
    for (const auto& symbol : lsystem::turtle_symbols()) {
        std::string text = "`";
        text += symbol.symbol;
        if (text == "`|") text = "<code>&#124;";
        EXPECT_NE(manual.find(text), std::string::npos) << symbol.symbol;
    }
}

}  // namespace
}  // namespace sinew
