#include "sinew/grow/program.h"

#include <gmock/gmock.h>

#include "grow/grow_testing.h"

namespace sinew::lsystem {
namespace {

using sinew::testing::parsed;

TEST(Program, TellsSymbolsApartByTheirNumberOfArguments) {
    const Grammar grammar = parsed("%axiom F F(1) F(2) F(1, 2)\n");
    const auto program = compile(grammar);
    ASSERT_TRUE(program);
    EXPECT_EQ(program->symbols.size(), 3u);
    EXPECT_EQ(program->axiom[1], program->axiom[2]);
    EXPECT_THAT(program->axiom_arguments, ::testing::ElementsAre(1, 2, 1, 2));
}

TEST(Program, ConstantsFollowThoseThatAreGivenInstead) {
    const Grammar grammar = parsed("%axiom F(b)\n%steps 2*a\na = 2\nb = a + 1\n");
    const auto program = compile(grammar, {.constants = {{"a", 5}}});
    ASSERT_TRUE(program);
    EXPECT_THAT(program->constants, ::testing::ElementsAre(5, 6));
    EXPECT_EQ(program->steps, 10);
    EXPECT_THAT(program->axiom_arguments, ::testing::ElementsAre(6));
    EXPECT_EQ(compile(grammar, {.steps = 3})->steps, 3);
}

TEST(Program, RefusesConstantsThatTheGrammarHasNot) {
    const Grammar grammar = parsed("%axiom F\na = 2\nb = 3\n");
    const auto unknown = compile(grammar, {.constants = {{"c", 5}}});
    ASSERT_FALSE(unknown);
    EXPECT_EQ(unknown.error().kind, ErrorKind::call);
    EXPECT_EQ(unknown.error().text(), "test.lsys: there is no constant 'c'; there are a, b");
    EXPECT_FALSE(compile(grammar, {.constants = {{"a", std::numeric_limits<double>::quiet_NaN()}}}));
    EXPECT_FALSE(compile(grammar, {.steps = -1}));
}

TEST(Program, ConstantsMayDrawFromTheSeed) {
    const Grammar grammar = parsed("%axiom F\n%seed 4\na = random(0, 1)\nb = random(0, 1)\n");
    const auto first = compile(grammar), again = compile(grammar), other = compile(grammar, {.seed = 5});
    EXPECT_EQ(first->constants, again->constants);
    EXPECT_NE(first->constants[0], first->constants[1]);
    EXPECT_NE(first->constants[0], other->constants[0]);
}

TEST(Program, TriesProductionsWithContextFirst) {
    const Grammar grammar = parsed("%axiom A\nA -> F\nB < A -> F\nA > B -> F\n");
    const auto program = compile(grammar);
    ASSERT_TRUE(program);
    EXPECT_THAT(program->symbols[program->axiom[0]].rules, ::testing::ElementsAre(1, 2, 0));
    EXPECT_TRUE(program->context);
    EXPECT_FALSE(program->chance);
}

}  // namespace
}  // namespace sinew::lsystem
