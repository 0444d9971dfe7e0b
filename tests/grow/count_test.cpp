#include "sinew/grow/count.h"

#include <atomic>
#include <cmath>

#include "grow/grow_testing.h"

namespace sinew::lsystem {
namespace {

using sinew::testing::error_of;
using sinew::testing::grown;
using sinew::testing::parsed;

std::optional<Count> counted(std::string_view text, std::optional<int> steps = {}) {
    const Grammar grammar = parsed(text);
    auto program = compile(grammar, {.steps = steps});
    return count_nodes(grammar, *program);
}

TEST(Count, IsWhatGrows) {
    const std::string_view grammars[] = {
        "%axiom F\nF -> F[+F]F[-F]F\n",
        "%axiom A(1)\nA(l) : l > 0.1 -> F(l)[+A(l*0.7)][-A(l*0.5)]\nA(l) : l <= 0.1 -> [B]F(l)\n",
        "%axiom A(6)\nA(t) : t > 0 -> F A(t-1) [+ B(t, 2)]\nB(t, x) : x < t -> F(x) B(t, x+1)\n",
        "%axiom f A\nA -> [F]f[F]A\n",
        "%axiom f[[.][F]]A\nA -> F f A [B] .\nB -> f B [C . C]\nC -> . .\n",
        "%axiom A\nA -> F[+A%B]F[-A]F\nB -> F F\n",
        "%axiom [A]F[A]\nA -> F B A\nB -> [+F]F[A%F]\n%finally\nB -> F % F\nA -> [F][F]\n",
        "%axiom FA%F[A]\nA -> A A\n",
    };
    for (const std::string_view text : grammars)
        for (int steps = 0; steps < 7; ++steps) {
            const auto count = counted(text, steps);
            ASSERT_TRUE(count) << text;
            GrowOptions options{.steps = steps};
            if (count->nodes == 0) continue;
            EXPECT_EQ(count->nodes, grown(text, options).nodes.size()) << text << steps;
        }
}

TEST(Count, TakesNoTimeForATreeThatWouldFillTheWorld) {
    EXPECT_EQ(counted("%axiom A(1)\nA(l) -> F(l)[+A(l*.7)]A(l*.8)\n", 60)->nodes, 1ull << 60);
    EXPECT_EQ(counted("%axiom F\nF -> FF\n", 4000)->nodes, countless);
    EXPECT_EQ(counted("%axiom F A\nA -> FA\n", 100000)->nodes, 100002u);
}

TEST(Count, LeavesChanceAndContextToTheGuard) {
    EXPECT_FALSE(counted("%axiom F\nF ->(1) F F\nF ->(2) F\n"));
    EXPECT_FALSE(counted("%axiom F\nF < F -> F F\n"));
    EXPECT_FALSE(counted("%axiom F(1)\nF(x) : random(0, 1) < 0.5 -> F(x) F(x)\n"));
}

TEST(Count, IsInTheGuardsMessage) {
    EXPECT_EQ(error_of("%axiom F\nF -> FF\n%steps 40\n"),
              "test.lsys: the skeleton would have 1099511627777 nodes, and the limit is 10000000 nodes; take "
              "fewer steps or raise the limit");
    EXPECT_EQ(error_of("%axiom F\nF -> FF\n%steps 10\n", {.limit = 1025}), "");
    EXPECT_NE(error_of("%axiom F\nF -> FF\n%steps 10\n", {.limit = 1024}), "");
    EXPECT_EQ(error_of("%axiom FA\nA -> AA\n%steps 60\n", {.limit = 1000}),
              "test.lsys: growing would take 2305843009213693953 modules, and a limit of 1000 nodes allows "
              "64000; take fewer steps or raise the limit");
}

TEST(Count, GoesOnBeyondTheLimitWhereOnlyGrowingTells) {
    const std::string chance = "%axiom F\nF ->(1) FF\n%steps ";
    EXPECT_EQ(error_of(chance + "11\n", {.limit = 2000}),
              "test.lsys: the skeleton would have 2049 nodes, and the limit is 2000 nodes; take fewer steps "
              "or raise the limit");
    EXPECT_EQ(error_of(chance + "50\n", {.limit = 2000}),
              "test.lsys: the skeleton would have more than 8000 nodes, and the limit is 2000 nodes; take "
              "fewer steps or raise the limit");
    const std::string context = "%axiom B F\nB < F -> FF\nF < F -> FF\n%steps ";
    EXPECT_EQ(error_of(context + "11\n", {.limit = 2000}),
              "test.lsys: the skeleton would have 2049 nodes, and the limit is 2000 nodes; take fewer steps "
              "or raise the limit");
    EXPECT_EQ(error_of(context + "50\n", {.limit = 2000}),
              "test.lsys: the skeleton would have more than 8000 nodes after 13 of 50 steps, and the limit "
              "is 2000 nodes; take fewer steps or raise the limit");
}

TEST(Count, GivesUpWithinALevel) {
    // Two steps of a thousand kinds each come to as many as may be told apart, a third to a thousand times that.
    std::string text = "%axiom A(1)\n%steps 3\nA(x) : x < 1e18 -> ";
    for (int i = 0; i < 1500; ++i) text += "A(x*1500+" + std::to_string(i) + ")";
    const Grammar grammar = parsed(text + "\n");
    auto program = compile(grammar);
    EXPECT_FALSE(count_nodes(grammar, *program));
    const std::atomic<bool> cancel = true;
    EXPECT_FALSE(count_nodes(grammar, *program, Progress({}, &cancel)));
}

}  // namespace
}  // namespace sinew::lsystem
