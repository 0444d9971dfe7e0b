#include <gmock/gmock.h>

#include "grow/grow_testing.h"
#include "sinew/grow/derive.h"

namespace sinew {
namespace {

using sinew::testing::error_of;
using sinew::testing::grown;
using sinew::testing::lengths;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string shown = "\n%finally\nA -> F(1)\nB -> F(2)\nC -> F(3)\nS -> F(9)\n";

TEST(DeriveInContext, SendsASignalAlongAString) {  // section 1.8 of the book
    const std::string signal = "%axiom BAAAA\nB < A -> B\nB -> A" + shown + "%steps ";
    EXPECT_THAT(lengths(grown(signal + "0")), ElementsAre(2, 1, 1, 1, 1));
    EXPECT_THAT(lengths(grown(signal + "1")), ElementsAre(1, 2, 1, 1, 1));
    EXPECT_THAT(lengths(grown(signal + "3")), ElementsAre(1, 1, 1, 2, 1));
    EXPECT_THAT(lengths(grown(signal + "5")), ElementsAre(1, 1, 1, 1, 1));
}

TEST(DeriveInContext, PassesOverBranchesAsInTheBook) {
    // BC < S > G[H]M fits S in ABC[DE][SG[HI[JK]L]MNO].
    const std::string text = "%axiom ABC[DE][SG[HI[JK]L]MNO]\n";
    EXPECT_THAT(lengths(grown(text + "BC < S > G[H]M -> F(7)\n")), ElementsAre(7));
    for (const char* context :
         {"AC < S", "S > GM", "S > G[I]M", "S > G[HIL]MN", "BC < S > GH", "C < S > G[HI]MNO", "ABC < S"}) {
        const bool fits = std::string(context).find("AC") == std::string::npos &&
                          std::string(context).find("[I]") == std::string::npos &&
                          std::string(context).find("GH") == std::string::npos;
        EXPECT_EQ(lengths(grown(text + context + " -> F(7)\n%finally\nS -> F(1)\n")),
                  std::vector<double>{fits ? 7.0 : 1.0})
            << context;
    }
}

TEST(DeriveInContext, TriesTheBranchesInTurn) {
    EXPECT_THAT(lengths(grown("%axiom S[A][B]C\nS > [B]C -> F(7)\n")), ElementsAre(7));
    EXPECT_THAT(lengths(grown("%axiom S[A][B]C\nS > [A][B]C -> F(7)\n")), ElementsAre(7));
    EXPECT_THAT(lengths(grown("%axiom S[A][B]C\nS > [B][A]C -> F(7)\n%finally\nS -> F(1)\n")),
                ElementsAre(1));
}

TEST(DeriveInContext, LooksThroughWhatIsIgnored) {
    const std::string text = "%axiom B + - A\nB < A -> S" + shown;
    EXPECT_THAT(lengths(grown(text)), ElementsAre(2, 1));
    EXPECT_THAT(lengths(grown(text, {})), ElementsAre(2, 1));
    EXPECT_THAT(lengths(grown("%ignore + -\n" + text)), ElementsAre(2, 9));
    EXPECT_THAT(lengths(grown("%ignore +-\n%axiom A+-B\nA > B -> S" + shown)), ElementsAre(9, 2));
}

TEST(DeriveInContext, TakesParametersOfTheNeighbours) {
    // Section 1.10.2: A(4)B(5)C(6) => A(4)E(4.5)F(5.5)C(6)
    EXPECT_THAT(
        lengths(grown("%axiom A(4) B(5) C(6)\nA(x) < B(y) > C(z) : x+y+z > 10 -> E((x+y)/2) F((y+z)/2)\n"
                      "%finally\nA(x) -> F(x)\nE(x) -> F(x)\nC(x) -> F(x)\n")),
        ElementsAre(4, 4.5, 5.5, 6));
}

TEST(DeriveInContext, PrefersAProductionWithContext) {
    EXPECT_THAT(lengths(grown("%axiom A B\nB -> F(1)\nA < B -> F(2)\n")), ElementsAre(2));
}

TEST(DeriveInContext, GivesTheSameAsWithoutContexts) {
    // A production whose context never fits changes the way of deriving, and nothing else.
    const std::string text =
        "%axiom A(3)\n%steps 8\nA(x) ->(x) F(random(1, x)) [+(normal(0, 30)) B A(x*0.9)] B % F\nA(x) ->(1) "
        "F(x) [&A(x)] /(x) A(x+0.1)\n"
        "B ->(1) F B\nB ->(2) % F\n%finally\nA(x) -> F(random(0.1, 0.2))\n";
    const Document free = grown(text), in_context = grown(text + "Z < Z -> Z\n");
    ASSERT_EQ(free.nodes.size(), in_context.nodes.size());
    ASSERT_GT(free.nodes.size(), 15u);
    for (std::size_t i = 0; i < free.nodes.size(); ++i)
        EXPECT_EQ(free.nodes[i].position, in_context.nodes[i].position);
}

TEST(DeriveInContext, EndsWhereAStepChangesNothing) {
    EXPECT_THAT(lengths(grown("%axiom A F(2)\n%steps 1000000000\nA < A -> A\n")), ElementsAre(2));
    EXPECT_THAT(lengths(grown("%axiom BAAF\n%steps 1000000000\nB < A -> B\n%finally\nB -> F(2)\n")),
                ElementsAre(2, 2, 2, 1))
        << "a signal that has come to the end";
}

TEST(DeriveInContext, TakesNoMoreStepsThanTheLimit) {
    const std::string flips = "%axiom ABF\nA < B -> C\nA < C -> B\n%steps ";
    EXPECT_EQ(error_of(flips + "1000", {.limit = 1000}), "");
    EXPECT_THAT(error_of(flips + "1002", {.limit = 1000}),
                HasSubstr("1002 steps with contexts are more than"));
}

TEST(DeriveInContext, LooksAtNoMoreThanTheLimitAllows) {
    // Which of thirty branches the fifteen of the pattern are is tried in every way, since no B follows.
    std::string branches, pattern;
    for (int i = 0; i < 30; ++i) branches += "[A]";
    for (int i = 0; i < 15; ++i) pattern += "[A]";
    const std::string text = "%axiom S" + branches + "F\nS > " + pattern + "B -> F\n";
    EXPECT_THAT(error_of(text, {.limit = 1000}), HasSubstr("contexts that look at more than 256000 modules"));
}

}  // namespace
}  // namespace sinew
