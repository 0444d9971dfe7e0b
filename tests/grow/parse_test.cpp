#include "sinew/grow/parse.h"

#include <fstream>
#include <sstream>

#include "grow/grow_testing.h"

namespace sinew {
namespace {

using testing::error_of;
using testing::parsed;

/// errors.txt: blocks of a grammar, a line `==> message`, and an empty line.
TEST(Parse, EveryCaseOfTheCorpusGivesItsMessage) {
    std::ifstream file(SINEW_GROW_ERRORS);
    ASSERT_TRUE(file) << SINEW_GROW_ERRORS;
    int cases = 0;
    std::string text;
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("==> ")) {
            text += line + "\n";
            continue;
        }
        EXPECT_EQ(error_of(text), "test.lsys:" + line.substr(4)) << "in\n" << text;
        ++cases;
        text.clear();
        std::getline(file, line);
    }
    EXPECT_GT(cases, 50);
}

TEST(Parse, ReadsAllPartsOfAProduction) {
    const Grammar grammar =
        parsed("%axiom A\nB(a) C < A(l, w) > [D] E(e) : l > w && e < 1 ->(2*l) F(l) [ +(a) A(l, 2) ]\n");
    ASSERT_EQ(grammar.productions.size(), 1u);
    const auto& p = grammar.productions[0];
    EXPECT_EQ(p.left.size(), 2u);
    EXPECT_EQ(p.predecessor.parameters, (std::vector<std::string>{"l", "w"}));
    EXPECT_EQ(p.right.size(), 4u);
    EXPECT_EQ(p.condition.text, "l > w && e < 1");
    EXPECT_EQ(p.weight.text, "2*l");
    ASSERT_EQ(p.successor.size(), 5u);
    EXPECT_EQ(p.successor[3].arguments[1].text, "2");
    EXPECT_FALSE(p.finally);
}

TEST(Parse, TakesSymbolsApart) {
    EXPECT_EQ(parsed("%axiom FF+F-F 0 1 Leaf @cube Leaflet(2)\n").axiom.size(), 20u);
    const Grammar declared = parsed("%modules Leaf, Leaflet\n%axiom FF+F-F01Leaf@cube Leaflet(2)\n");
    EXPECT_EQ(declared.axiom.size(), 11u);
    EXPECT_EQ(declared.axiom[8].symbol.text, "Leaf");
    EXPECT_EQ(declared.axiom[10].symbol.text, "Leaflet");
}

TEST(Parse, GoesOnInIndentedLines) {
    const Grammar grammar = parsed("\n%axiom F\n   # a remark\n\n  +(4)\n\tF\nA\n -> # arrow\r\n  F\n");
    EXPECT_EQ(grammar.axiom.size(), 3u);
    EXPECT_EQ(grammar.productions.size(), 1u);
}

TEST(Parse, ReadsTheArrowAndStarsOfTheBook) {
    const Grammar grammar =
        parsed("%axiom A(1)\n* < A(x) > * : * --> F(x)\nA(x) : x-->F\nB(x) : x - 1 -->F(x)\n");
    EXPECT_TRUE(grammar.productions[0].left.empty());
    EXPECT_TRUE(grammar.productions[0].condition.empty());
    EXPECT_EQ(grammar.productions[1].condition.text, "x");
    EXPECT_EQ(grammar.productions[2].condition.text, "x - 1");
}

TEST(Parse, TellsConstantsWithTheirValuesAndRemarks) {
    const Grammar grammar = parsed("%axiom F(b)\n%steps a + 1\n%seed 7\na = 2   # how many\nb = a*3\n");
    ASSERT_EQ(grammar.constants.size(), 2u);
    EXPECT_EQ(grammar.constants[0].name, "a");
    EXPECT_EQ(grammar.constants[0].remark, "how many");
    EXPECT_EQ(grammar.constants[1].value, 6);
    EXPECT_EQ(grammar.steps, 3);
    EXPECT_EQ(grammar.seed, 7u);
}

TEST(Parse, ReadsUnitAndSymmetry) {
    const Grammar mirror = parsed("%axiom F\n%unit mm\n%symmetry mirror y\n");
    EXPECT_EQ(mirror.unit, "mm");
    EXPECT_EQ(mirror.symmetry, (Symmetry{Symmetry::Kind::mirror, 1, 1}));
    EXPECT_EQ(parsed("%axiom F\n%symmetry radial z 8").symmetry, (Symmetry{Symmetry::Kind::radial, 2, 8}));
}

TEST(Parse, AcceptsAnyLineEndsAndABom) { EXPECT_EQ(parsed("\xEF\xBB\xBF%axiom F\r\n%steps 4\r\n").steps, 4); }

TEST(Parse, TheLongestDeclaredNameWins) {
    const Grammar grammar = parsed("%modules ab, abcd, bb\n%axiom abcdabcab F\n");
    std::vector<std::string> symbols;
    for (const auto& module : grammar.axiom) symbols.push_back(module.symbol.text);
    EXPECT_EQ(symbols, (std::vector<std::string>{"abcd", "ab", "c", "ab", "F"}));
}

}  // namespace
}  // namespace sinew
