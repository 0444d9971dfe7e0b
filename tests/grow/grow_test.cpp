#include "sinew/grow/grow.h"

#include <bit>
#include <cmath>

#include "grow/grow_testing.h"
#include "sinew/grow/random.h"

namespace sinew {
namespace {

using sinew::testing::grown;
using sinew::testing::parsed;

/// What any grammar of a family gives: chance, all turns, branches, gaps, types and sections.
std::string any_grammar(unsigned seed) {
    static constexpr const char* parts[] = {"F",
                                            "F(x)",
                                            "f",
                                            "+",
                                            "-(x*20)",
                                            "&",
                                            "^(33)",
                                            "/",
                                            "\\(10)",
                                            "|",
                                            "$",
                                            "!",
                                            "!(x/5)",
                                            "[A(x)]",
                                            "[+B]",
                                            "[-F B]",
                                            "A(x*.8)",
                                            "B",
                                            ".",
                                            "@cube",
                                            "@cone",
                                            "@ball",
                                            "[@negative F]",
                                            "@hemisphere",
                                            "@sharp",
                                            "@rectangular",
                                            "@scale(x, 2)",
                                            "@round",
                                            "F[+F%F]F",
                                            "[f F]",
                                            "@tropism(0.2)",
                                            "@cube(x, x, 1)",
                                            "[[F].]"};
    lsystem::Random random(seed);
    const auto some = [&](int count) {
        std::string text;
        for (int i = 0; i < count; ++i)
            text += std::string(parts[static_cast<int>(random.uniform() * std::size(parts))]) + " ";
        return text;
    };
    std::string text = "%axiom F A(1) B\n%angle 25\n%radius 0.2\nx = 1\n";
    text += "A(x) ->(2) " + some(6) + "\nA(x) : x > 0.3 ->(1) " + some(9) + "\n";
    text += "B -> " + some(5) + "\n";
    if (random.uniform() < 0.5) text += "F < B -> " + some(4) + "\n";
    return text;
}

TEST(Grow, MakesSoundDocumentsFromAnyGrammar) {
    for (unsigned seed = 0; seed < 400; ++seed) {
        const std::string text = any_grammar(seed);
        const auto grammar = parse_grammar(text, "any");
        ASSERT_TRUE(grammar) << grammar.error().text() << "\n" << text;
        for (int steps : {1, 3, 5}) {
            const auto document = grow(*grammar, {.steps = steps, .seed = seed, .limit = 20000});
            if (!document) {
                EXPECT_NE(document.error().message.find("limit"), std::string::npos)
                    << document.error().text() << "\n"
                    << text;
                continue;
            }
            const auto valid = validate(*document);
            EXPECT_TRUE(valid) << valid.error().text() << "\n" << text;
            for (const Node& node : document->nodes) {
                if (node.parent < 0) continue;
                ASSERT_LT(node.parent, node.id);
                EXPECT_NE(node.position, document->nodes[node.parent].position);
            }
        }
    }
}

TEST(Grow, GivesTheSameBytesAgain) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        const Grammar grammar = parsed(any_grammar(seed));
        const auto a = grow(grammar, {.steps = 4, .seed = 9, .limit = 20000}),
                   b = grow(grammar, {.steps = 4, .seed = 9, .limit = 20000});
        ASSERT_EQ(a.has_value(), b.has_value());
        if (!a) continue;
        ASSERT_EQ(a->nodes.size(), b->nodes.size());
        for (std::size_t i = 0; i < a->nodes.size(); ++i)
            EXPECT_EQ(a->nodes[i].position, b->nodes[i].position);
    }
}

// One number for all bits of a tree that takes every way to a number: drawn lengths and angles, powers,
// logarithms, tropism. It is the same for g++ and clang, on any processor; if it changes, seeds have lost
// their meaning.
TEST(Grow, GivesTheSameBytesOnEveryMachine) {
    const Document document = grown(
        "%axiom A(1, 0.1)\n%steps 7\n%seed 42\n%tropism 0.1, 0.2, -1, 0.1\n"
        "A(l, w) ->(2) !(w) F(l*random(0.8, 1.2)) [+(normal(30, 7)) A(l*0.8, w^1.1)] /(137.5) A(log(1+l), "
        "w*exp(-0.3))\n"
        "A(l, w) ->(1) !(w) F(l^0.5) [&(atan2(1, l)) A(l*sin(50), w*0.7)] $ A(l, w*sqrt(0.5))\n");
    std::uint64_t hash = 1469598103934665603u;
    for (const Node& node : document.nodes)
        for (double value : {node.position.x(), node.position.y(), node.position.z(), node.radius})
            hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 1099511628211u;
    EXPECT_EQ(document.nodes.size(), 128u);
    EXPECT_EQ(hash, 4899882526871577765u);
}

TEST(Grow, CarriesUnitAndSymmetryIntoTheDocument) {
    const Document document = grown("%axiom F\n%unit mm\n%symmetry radial z 5\n");
    EXPECT_EQ(document.unit, "mm");
    EXPECT_EQ(document.symmetry.count, 5);
}

TEST(Grow, ReportsProgressUpToTheEnd) {
    double last = 0;
    const Progress progress([&](double share, std::string_view) {
        EXPECT_GE(share, last);
        EXPECT_LE(share, 1);
        last = share;
    });
    ASSERT_TRUE(grow(parsed("%axiom A\nA -> FA\n%steps 50000\n"), {}, progress));
    EXPECT_GT(last, 0.5);
}

}  // namespace
}  // namespace sinew
