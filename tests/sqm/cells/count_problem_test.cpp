#include "sinew/sqm/cells/count_problem.h"

#include <algorithm>
#include <functional>

#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

std::vector<std::int32_t> sums(const CountProblem& problem) {
    std::vector<std::int32_t> sum(problem.cells.size(), 0);
    for (const CountArc& arc : problem.arcs) {
        sum[arc.a] += arc.pieces;
        if (arc.b >= 0) sum[arc.b] += arc.pieces;
    }
    return sum;
}
bool is_met(const CountProblem& problem) {
    const std::vector<std::int32_t> sum = sums(problem);
    for (std::size_t c = 0; c < sum.size(); ++c) {
        const CountCell& cell = problem.cells[c];
        if (cell.exact ? sum[c] != cell.target : sum[c] < cell.target) return false;
    }
    return std::all_of(problem.arcs.begin(), problem.arcs.end(),
                       [](const CountArc& arc) { return arc.pieces >= arc.least; });
}
/// Tries all numbers of pieces up to the greatest target.
bool has_solution(CountProblem problem) {
    std::int32_t most = 0;
    for (const CountCell& cell : problem.cells) most = std::max(most, cell.target);
    const std::function<bool(std::size_t)> try_arc = [&](std::size_t a) {
        if (a == problem.arcs.size()) return is_met(problem);
        for (std::int32_t n = problem.arcs[a].least; n <= std::max(most, problem.arcs[a].least); ++n) {
            problem.arcs[a].pieces = n;
            if (try_arc(a + 1)) return true;
        }
        return false;
    };
    return try_arc(0);
}

CountProblem random_problem(property::Random& random) {
    CountProblem problem;
    const int cells = random.whole(2, 4), arcs = random.whole(cells, 6);
    for (int c = 0; c < cells; ++c) problem.cells.push_back({random.whole(2, 6), random.chance(0.6), false});
    for (int a = 0; a < arcs; ++a) {
        const int from = random.below(cells), to = random.whole(-1, cells - 1);
        problem.arcs.push_back({from, to, random.whole(1, 2), random.between(0.1, 2), 1});
    }
    return problem;
}

TEST(CountProblem, IsSolvedWhereverTryingEverythingSolvesIt) {
    property::Random random(8);
    int solvable = 0;
    for (int round = 0; round < 1000; ++round) {
        CountProblem problem = random_problem(random);
        const bool expected = has_solution(problem), solved = problem.solve();
        EXPECT_EQ(solved, expected) << round;
        EXPECT_TRUE(!solved || is_met(problem));
        solvable += expected;
    }
    EXPECT_GT(solvable, 250);
    EXPECT_LT(solvable, 750);
}

TEST(CountProblem, SplitsTheLongestPieces) {
    CountProblem problem;
    problem.cells = {{12, true, false}};
    problem.arcs = {{0, -1, 1, 3.0, 1}, {0, -1, 1, 2.0, 1}, {0, -1, 1, 1.0, 1}};
    ASSERT_TRUE(problem.solve());
    EXPECT_EQ(problem.arcs[0].pieces, 6);
    EXPECT_EQ(problem.arcs[1].pieces, 4);
    EXPECT_EQ(problem.arcs[2].pieces, 2);
}

TEST(CountProblem, PutsWhatIsLeftOverWhereItIsCheap) {
    CountProblem problem;
    problem.cells = {{5, true, false}, {1, false, false}, {1, false, true}};
    problem.arcs = {{0, 1, 1, 9.0, 1}, {0, 2, 1, 1.0, 1}};
    ASSERT_TRUE(problem.solve());
    EXPECT_EQ(sums(problem), (std::vector<std::int32_t>{5, 1, 4}));
}

TEST(CountProblem, RefusesWhatCannotBe) {
    CountProblem problem;
    problem.cells = {{4, true, false}, {5, true, false}};
    problem.arcs = {{0, 1}};
    EXPECT_FALSE(problem.solve());
    problem.cells = {{1, true, false}};
    problem.arcs = {{0, -1}, {0, -1}};
    EXPECT_FALSE(problem.solve());
}

}  // namespace
}  // namespace sinew::sqm
