#include "sinew/grow/formula.h"

#include <gtest/gtest.h>

namespace sinew::lsystem {
namespace {

struct FormulaTest : ::testing::Test {
    double value(const std::string& text) {
        auto formula = compiler.compile(Text{text, 0}, variables);
        EXPECT_TRUE(formula) << text << ": " << formula.error().text();
        return formula ? formula->value() : 0;
    }
    std::string error(const std::string& text) {
        const auto formula = compiler.compile(Text{text, 0}, variables);
        return formula ? "" : formula.error().text();
    }

    Source source{std::string(200, ' '), "f"};
    Random random;
    FormulaCompiler compiler{source, random};
    double x = 2, length = 3;
    std::vector<Variable> variables{{"x", &x}, {"length", &length}};
};

TEST_F(FormulaTest, KnowsTheUsualOperators) {
    EXPECT_EQ(value("1 + 2*length"), 7);
    EXPECT_EQ(value("2^3^2"), 512);
    EXPECT_EQ(value("-x^2"), -4);
    EXPECT_EQ(value("x^-1"), 0.5);
    EXPECT_EQ(value("x > 1 && !(length < 2) ? 10 : 20"), 10);
    EXPECT_EQ(value("x == 2 || 1/0 > 3"), 1);
    EXPECT_EQ(value("x != 2"), 0);
    EXPECT_EQ(value("1.5e1 + .5"), 15.5);
}

TEST_F(FormulaTest, MeasuresAnglesInDegrees) {
    EXPECT_EQ(value("sin(90)"), 1);
    EXPECT_EQ(value("cos(180)"), -1);
    EXPECT_NEAR(value("tan(45)"), 1, 1e-15);
    EXPECT_NEAR(value("atan2(1, -1)"), 135, 1e-12);
}

TEST_F(FormulaTest, KnowsItsFunctions) {
    EXPECT_EQ(value("sqrt(16) + abs(-1) + sign(-3)"), 4);
    EXPECT_EQ(value("floor(-1.5) + ceil(1.2) + round(2.5)"), 3);
    EXPECT_EQ(value("mod(-1, 3)"), 2);
    EXPECT_EQ(value("min(1, 2) + 10*max(1, 2)"), 21);
    EXPECT_NEAR(value("log(exp(2))"), 2, 1e-15);
    EXPECT_NEAR(value("pi"), 3.14159265358979, 1e-14);
}

TEST_F(FormulaTest, SeesItsVariablesChange) {
    const auto formula = compiler.compile(Text{"x * length", 0}, variables);
    ASSERT_TRUE(formula);
    x = 5;
    EXPECT_EQ(formula->value(), 15);
}

TEST_F(FormulaTest, EvaluatesSeveralAtOnceInOrder) {
    const Text texts[] = {{"x", 0}, {"7", 0}, {"x > 1 ? length : 0", 0}, {"max(x, length)", 0}};
    const auto formula = compiler.compile(texts, variables);
    ASSERT_TRUE(formula);
    const auto values = formula->values();
    EXPECT_EQ(std::vector(values.begin(), values.end()), (std::vector<double>{2, 7, 3, 3}));
}

TEST_F(FormulaTest, TakesMoreTextThanMuParserDoes) {
    std::vector<Text> texts;
    for (int i = 0; i < 30000; ++i) texts.push_back({std::to_string(i) + "*x", 0});
    const auto formula = compiler.compile(texts, variables);
    ASSERT_TRUE(formula);
    const auto values = formula->values();
    ASSERT_EQ(values.size(), texts.size());
    for (std::size_t i = 0; i < texts.size(); ++i) EXPECT_EQ(values[i], 2.0 * static_cast<double>(i));
    EXPECT_EQ(error("x" + std::string(20000, '+') + "1"),
              "f:1:1: this formula is longer than 19999 characters");
}

TEST_F(FormulaTest, DrawsAnewEachTime) {
    const auto formula = compiler.compile(Text{"random(0, 1)", 0}, variables);
    ASSERT_TRUE(formula);
    random = Random(5);
    const double first = formula->value(), second = formula->value();
    EXPECT_NE(first, second);
    random = Random(5);
    EXPECT_EQ(formula->value(), first);
}

TEST_F(FormulaTest, SaysWhatWasExpectedAndWhere) {
    EXPECT_EQ(error("x +"), "f:1:4: expected a value, found the end of the line");
    EXPECT_EQ(error("x + * 2"), "f:1:5: expected a value, found '*'");
    EXPECT_EQ(error("(x + 1"), "f:1:7: expected ')', found the end of the line");
    EXPECT_EQ(error("x length"), "f:1:3: expected an operator, found 'length'");
    EXPECT_EQ(error("3x"), "f:1:2: expected an operator, found 'x'");
    EXPECT_EQ(error("x = 2"), "f:1:3: expected '==', found '='");
    EXPECT_EQ(error("x & 1"), "f:1:3: expected '&&', found '&'");
    EXPECT_EQ(error("sqrt x"), "f:1:1: expected '(' after the function sqrt");
    EXPECT_EQ(error("min(1)"), "f:1:6: too few arguments for min");
    EXPECT_EQ(error("sqrt(1, 2)"), "f:1:10: too many arguments for sqrt");
    EXPECT_EQ(error("1e999"), "f:1:1: expected a number that a double can hold");
    EXPECT_EQ(error("x ? 1"), "f:1:6: expected ':' of the '?' before, found the end of the line");
    EXPECT_EQ(error("1, 2"), "f:1:1: a ',' cannot stand here");
    EXPECT_EQ(error("x ~ 2"), "f:1:3: '~' cannot stand in a formula");
    EXPECT_EQ(error("\"a\""), "f:1:1: '\"' cannot stand in a formula");
    EXPECT_EQ(error("wide"), "f:1:1: unknown name 'wide'; known here: x, length, pi");
}

TEST(NamesIn, ListsEachNameOnce) {
    EXPECT_EQ(names_in({"b*sin(a) + 2e3*b", 0}), (std::vector<std::string>{"a", "b", "sin"}));
}

}  // namespace
}  // namespace sinew::lsystem
