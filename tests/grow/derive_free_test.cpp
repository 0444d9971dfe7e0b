#include <gmock/gmock.h>

#include <atomic>
#include <cmath>

#include "grow/grow_testing.h"
#include "sinew/grow/derive.h"

namespace sinew {
namespace {

using sinew::testing::grown;
using sinew::testing::lengths;
using sinew::testing::parsed;
using ::testing::ElementsAre;

TEST(DeriveFree, ReplacesAllModulesInEachStep) {
    // Anabaena, section 1.2 of the book: a cell divides into a long and a short one, by turns.
    const std::string anabaena =
        "%modules ar al br bl\n%axiom ar\n"
        "ar -> al br\nal -> bl ar\nbr -> ar\nbl -> al\n"
        "%finally\nar -> F(1)\nal -> F(2)\nbr -> F(3)\nbl -> F(4)\n%steps ";
    EXPECT_THAT(lengths(grown(anabaena + "0")), ElementsAre(1));
    EXPECT_THAT(lengths(grown(anabaena + "1")), ElementsAre(2, 3));
    EXPECT_THAT(lengths(grown(anabaena + "2")), ElementsAre(4, 1, 1));
    EXPECT_THAT(lengths(grown(anabaena + "3")), ElementsAre(2, 2, 3, 2, 3));
    EXPECT_THAT(lengths(grown(anabaena + "4")), ElementsAre(4, 1, 4, 1, 1, 4, 1, 1));
}

TEST(DeriveFree, EvaluatesParametersAndConditions) {
    // Figure 1.36 of the book: B(2)A(4,4) => B(1)B(4)A(1,0) => B(0)B(3)A(2,1) => C B(2)A(4,3) => C B(1)A(8,7)
    const std::string figure =
        "%axiom B(2) A(4, 4)\n"
        "A(x, y) : y <= 3 -> A(x*2, x+y)\nA(x, y) : y > 3 -> B(x) A(x/y, 0)\n"
        "B(x) : x < 1 -> C\nB(x) : x >= 1 -> B(x-1)\n"
        "%finally\nA(x, y) -> F(100 + 10*x + y)\nB(x) -> F(1 + x)\nC -> F(50)\n%steps ";
    EXPECT_THAT(lengths(grown(figure + "0")), ElementsAre(3, 144));
    EXPECT_THAT(lengths(grown(figure + "1")), ElementsAre(2, 5, 110));
    EXPECT_THAT(lengths(grown(figure + "2")), ElementsAre(1, 4, 121));
    EXPECT_THAT(lengths(grown(figure + "3")), ElementsAre(50, 3, 143));
    EXPECT_THAT(lengths(grown(figure + "4")), ElementsAre(50, 2, 187));
}

TEST(DeriveFree, TakesTheFirstProductionThatFits) {
    EXPECT_THAT(
        lengths(grown("%axiom A(2) A(5)\nA(x) : x > 3 -> F(1)\nA(x) -> F(2)\nA(x) : x > 4 -> F(3)\n")),
        ElementsAre(2, 1));
}

TEST(DeriveFree, CutsTheRestOfABranch) {
    EXPECT_THAT(lengths(grown("%axiom F(1)[F(2)[F(3)]%F(4)[F(5)]]F(6)\n")), ElementsAre(1, 2, 3, 6));
    EXPECT_THAT(lengths(grown("%axiom A F(6)\nA -> F(1)[B F(3)]B F(4)\nB -> F(2) % F(5)\n%steps 2\n")),
                ElementsAre(1, 2, 2));
}

TEST(DeriveFree, DrawsByWeight) {
    // 3 to 1 over 20,000 draws: within five standard deviations
    const Document document =
        grown("%axiom A(20000)\nA(n) : n > 0 -> B A(n-1)\nB ->(3) F(1)\nB ->(1) F(2)\n%steps 20002\n");
    double ones = 0;
    for (double length : lengths(document)) ones += length < 1.5;
    EXPECT_EQ(document.nodes.size(), 20001u);
    EXPECT_NEAR(ones / 20000, 0.75, 5 * std::sqrt(0.75 * 0.25 / 20000));
}

TEST(DeriveFree, NeverDrawsAWeightOfZero) {
    EXPECT_THAT(lengths(grown("%axiom A A A A\nA ->(0) F(1)\nA ->(2) F(2)\n")), ElementsAre(2, 2, 2, 2));
    EXPECT_THAT(lengths(grown("%axiom A A\nA ->(0) F(1)\nA -> F(3)\n")), ElementsAre(3, 3));
}

TEST(DeriveFree, OneMoreStepKeepsWhatWasThere) {
    const std::string bush =
        "%axiom A\nA ->(1) F(random(1, 2)) [+(normal(30, 5)) A] A\nA ->(1) F(random(1, 3)) A\n";
    for (int steps : {3, 5, 8}) {
        const Document before = grown(bush, {.steps = steps}), after = grown(bush, {.steps = steps + 1});
        ASSERT_GT(after.nodes.size(), before.nodes.size());
        for (const Node& node : before.nodes) {
            const auto same = [&](const Node& other) { return other.position == node.position; };
            EXPECT_TRUE(std::any_of(after.nodes.begin(), after.nodes.end(), same));
        }
    }
}

TEST(DeriveFree, SeedsDiffer) {
    const std::string text = "%axiom F(random(1, 2))\n";
    EXPECT_EQ(lengths(grown(text, {.seed = 1})), lengths(grown(text, {.seed = 1})));
    EXPECT_NE(lengths(grown(text, {.seed = 1})), lengths(grown(text, {.seed = 2})));
}

TEST(DeriveFree, StopsOnRequest) {
    const Grammar grammar = parsed("%axiom A\nA -> FA\n%steps 100000\n");
    const std::atomic<bool> cancel{true};
    const auto document = grow(grammar, {}, Progress({}, &cancel));
    ASSERT_FALSE(document);
    EXPECT_EQ(document.error().kind, ErrorKind::cancelled);
}

}  // namespace
}  // namespace sinew
