// Figures and tables of "The Algorithmic Beauty of Plants" (Prusinkiewicz, Lindenmayer, 1990).
#include <cmath>
#include <fstream>
#include <sstream>

#include "grow/grow_testing.h"

namespace sinew {
namespace {

using sinew::testing::grown;
using sinew::testing::lengths;

std::string example(const std::string& name) {
    std::ifstream file(std::string(SINEW_EXAMPLES) + "/" + name + ".lsys");
    EXPECT_TRUE(file) << name;
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

int depth_of(const Document& document, std::int32_t node) {
    int depth = 0;
    while ((node = document.nodes[node].parent) >= 0) ++depth;
    return depth;
}

double constant(const Grammar& grammar, const std::string& name) {
    for (const GrowConstant& c : grammar.constants)
        if (c.name == name) return c.value;
    ADD_FAILURE() << name;
    return 0;
}

class Figure26 : public ::testing::TestWithParam<const char*> {};

TEST_P(Figure26, DoublesWithEachStep) {
    for (int n = 1; n <= 14; ++n)
        EXPECT_EQ(grown(example(GetParam()), {.steps = n}).nodes.size(), std::size_t{1} << n);
}

TEST_P(Figure26, ThinsAndShortensByTheTable) {
    const std::string text = example(GetParam());
    const Grammar grammar = sinew::testing::parsed(text);
    const double wr = constant(grammar, "wr"), r1 = constant(grammar, "r1"), r2 = constant(grammar, "r2");
    const Document document = grown(text, {.steps = 8});
    const auto all = lengths(document);
    const double radius = document.nodes[0].radius, length = all[0];
    for (std::size_t i = 1; i < document.nodes.size(); ++i) {
        const int k = depth_of(document, static_cast<std::int32_t>(i)) - 1;
        EXPECT_NEAR(document.nodes[i].radius, radius * std::pow(wr, k), 1e-12 * radius);
        double nearest = 1;
        for (int branchings = 0; branchings <= k; ++branchings)
            nearest = std::min(nearest, std::abs(all[i - 1] / (length * std::pow(r1, k - branchings) *
                                                               std::pow(r2, branchings)) -
                                                 1));
        EXPECT_LT(nearest, 1e-9);
    }
}

TEST_P(Figure26, PutsBranchesAt137Degrees) {
    const Document document = grown(example(GetParam()), {.steps = 9});
    std::vector<double> directions;  // of the branches that leave the trunk, seen from above
    for (const Node& node : document.nodes) {
        if (node.parent < 0 || node.position.head<2>().norm() < 1e-9) continue;
        const Node& parent = document.nodes[node.parent];
        if (parent.position.head<2>().norm() > 1e-9) continue;
        const Vec3 way = node.position - parent.position;
        directions.push_back(std::atan2(way.y(), way.x()) * 180 / 3.141592653589793);
    }
    ASSERT_EQ(directions.size(), 8u);
    for (std::size_t i = 1; i < directions.size(); ++i) {
        const double turned = std::abs(std::remainder(directions[i] - directions[i - 1], 360));
        EXPECT_NEAR(turned, 137.5, 1e-9);
    }
}

INSTANTIATE_TEST_SUITE_P(Book, Figure26, ::testing::Values("honda_a", "honda_b", "honda_c", "honda_d"));

TEST(Figure27, ForksAtTheAnglesOfTheTable) {
    const std::string text = example("aono_kunii");
    const Grammar grammar = sinew::testing::parsed(text);
    EXPECT_EQ(grown(text, {.steps = 10}).nodes.size(), 1024u);
    const Document fork = grown(text, {.steps = 2});
    ASSERT_EQ(fork.nodes.size(), 4u);
    for (int branch : {0, 1}) {
        const Vec3 way = (fork.nodes[2 + branch].position - fork.nodes[1].position).normalized();
        EXPECT_NEAR(std::acos(way.z()) * 180 / 3.141592653589793,
                    constant(grammar, branch == 0 ? "a1" : "a2"), 1e-9);
    }
}

TEST(Figure28, GrowsThreeBranchesAndStretchesTheRest) {
    const std::string text = example("tropism_tree");
    const Grammar grammar = sinew::testing::parsed(text);
    for (int n = 0; n < 6; ++n) {
        const Document document = grown(text, {.steps = n});
        const auto all = lengths(document);
        EXPECT_EQ(all.size(), 1 + 2 * (std::pow(3, n) - 1));  // each apex: one segment and three more
        const double first = grown(text, {.steps = 0}).nodes.back().position.norm();
        EXPECT_NEAR(all[0] / (first * std::pow(constant(grammar, "lr"), n)), 1, 1e-12);
        EXPECT_NEAR(document.nodes[0].radius /
                        (grown(text, {.steps = 0}).nodes[0].radius * std::pow(constant(grammar, "vr"), n)),
                    1, 1e-12);
    }
}

TEST(Figure16, TheKochIslandCloses) {  // n = 3
    const Document document = grown("%axiom F-F-F-F\nF -> F-F+F+FF-F-F+F\n%steps 3\n");
    EXPECT_EQ(document.nodes.size(), 4 * std::size_t{512} + 1);
    EXPECT_EQ(document.nodes.back().position, document.nodes.front().position);
}

TEST(Figure124, PlantsHaveAsManySegmentsAsTheirProductionsSay) {
    const auto segments = [](const std::string& text, int n) {
        return static_cast<double>(lengths(grown("%angle 25\n" + text, {.steps = n})).size());
    };
    for (int n = 0; n < 5; ++n) {
        EXPECT_EQ(segments("%axiom F\nF -> F[+F]F[-F]F\n", n), std::pow(5, n));           // a
        EXPECT_EQ(segments("%axiom F\nF -> FF-[-F+F+F]+[+F-F-F]\n", n), std::pow(8, n));  // c
        EXPECT_EQ(segments("%axiom F X\nX -> F[+X]F[-X]+X\nF -> FF\n", n),
                  std::pow(2, n) + 2 * (std::pow(3, n) - std::pow(2, n)));  // d
    }
}

}  // namespace
}  // namespace sinew
