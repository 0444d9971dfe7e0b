#include "sinew/sqm/cells/count_problem.h"

#include <algorithm>
#include <numeric>
#include <queue>
#include <utility>

namespace sinew::sqm {
namespace {

/// Lengths of arcs that are images of each other differ by rounding: of such the first one is taken.
constexpr double by_more_than_rounding = 1 + 1e-9;

/// Arcs of a problem from which the longest one is not looked for among all each time.
constexpr std::ptrdiff_t very_many = 768;

constexpr std::int32_t no_state = -1;
// Instead of the arc of a step:
constexpr std::int32_t not_reached = -1, start_of_walk = -2;

constexpr std::int32_t short_at(std::int32_t cell) { return 2 * cell; }
constexpr std::int32_t over_at(std::int32_t cell) { return 2 * cell + 1; }
constexpr std::int32_t cell_of(std::int32_t state) { return state / 2; }
constexpr bool is_short(std::int32_t state) { return state % 2 == 0; }

}  // namespace

void CountProblem::change(CountArc& arc, std::int32_t by) {
    arc.pieces += by;
    lack_[arc.a] -= by;
    if (arc.b >= 0) lack_[arc.b] -= by;
}

void CountProblem::start() {
    lack_.clear();
    for (const CountCell& cell : cells) lack_.push_back(cell.target);
    arc_first_.assign(cells.size() + 1, 0);
    for (CountArc& arc : arcs) {
        arc.pieces = 0;
        change(arc, arc.least);
        ++arc_first_[arc.a + 1];
        if (arc.b >= 0 && arc.b != arc.a) ++arc_first_[arc.b + 1];
    }
    std::partial_sum(arc_first_.begin(), arc_first_.end(), arc_first_.begin());
    cell_arcs_.resize(arc_first_.back());
    queue_.assign(arc_first_.begin(), arc_first_.end() - 1);
    for (std::size_t i = 0; i < arcs.size(); ++i) {
        cell_arcs_[queue_[arcs[i].a]++] = static_cast<std::int32_t>(i);
        if (arcs[i].b >= 0 && arcs[i].b != arcs[i].a)
            cell_arcs_[queue_[arcs[i].b]++] = static_cast<std::int32_t>(i);
    }
    blocked_.assign(arcs.size(), 0);
}

/// Splits the arc with the longest pieces of those whose cells both lack some.
bool CountProblem::take_both_lacking() {
    CountArc* best = nullptr;
    for (CountArc& arc : arcs) {
        const bool lacking =
            lack_[arc.a] > 0 && (arc.b < 0 || (arc.b == arc.a ? lack_[arc.a] > 1 : lack_[arc.b] > 0));
        if (lacking && (!best || piece_length(arc) > piece_length(*best) * by_more_than_rounding))
            best = &arc;
    }
    if (best) change(*best, 1);
    return best != nullptr;
}

/// The same for very many arcs, of which one nearly as long as the longest may come first.
void CountProblem::take_all_both_lacking() {
    using Entry = std::pair<double, std::int32_t>;  // length of a piece, minus the arc
    std::priority_queue<Entry> longest;
    const auto is_lacking = [&](const CountArc& arc) {
        return lack_[arc.a] > 0 && (arc.b < 0 || (arc.b == arc.a ? lack_[arc.a] > 1 : lack_[arc.b] > 0));
    };
    for (std::size_t i = 0; i < arcs.size(); ++i)
        longest.emplace(piece_length(arcs[i]), -static_cast<std::int32_t>(i));
    while (!longest.empty()) {  // each turn takes an entry away or a piece of what the cells lack
        CountArc& arc = arcs[-longest.top().second];
        const std::int32_t index = longest.top().second;
        longest.pop();
        if (!is_lacking(arc)) continue;  // nor will it be: lacks only shrink here
        change(arc, 1);
        longest.emplace(piece_length(arc), index);
    }
}

/// Splits an arc that a cell shares with one that may have more than it asked for, a cheap one if there is
/// one.
bool CountProblem::take_free(std::int32_t cell) {
    CountArc* best = nullptr;
    bool best_cheap = false;
    for (std::int32_t i = arc_first_[cell]; i < arc_first_[cell + 1]; ++i) {
        CountArc& arc = arcs[cell_arcs_[i]];
        const std::int32_t beyond = other(arc, cell);
        if (beyond < 0 || beyond == cell || cells[beyond].exact) continue;
        const bool cheap = cells[beyond].cheap;
        if (!best || cheap > best_cheap ||
            (cheap == best_cheap && piece_length(arc) > piece_length(*best) * by_more_than_rounding)) {
            best = &arc;
            best_cheap = cheap;
        }
    }
    if (best) change(*best, 1);
    return best != nullptr;
}

/// Breadth first, from a cell that lacks a piece to the nearest place where a walk may end: a state is a cell
/// together with whether it would be a piece short or have one over if the walk ended there.
/// @return the state that the walk ends in; no_state if there is no walk
std::int32_t CountProblem::find_walk(std::int32_t cell) {
    steps_.assign(2 * cells.size(), {});
    steps_[short_at(cell)].arc = start_of_walk;
    queue_.assign(1, short_at(cell));
    for (std::size_t head = 0; head < queue_.size(); ++head) {
        const std::int32_t state = queue_[head], at = cell_of(state);
        for (std::int32_t i = arc_first_[at]; i < arc_first_[at + 1]; ++i) {
            const std::int32_t arc = cell_arcs_[i], beyond = other(arcs[arc], at);
            if (!is_short(state) && !may_lower(arc)) continue;
            if (beyond <
                0) {  // an arc that has no cell on its other side, where a piece more or less matters
                steps_.push_back({arc, state});
                return static_cast<std::int32_t>(steps_.size()) - 1;
            }
            // An arc is raised for a cell that is short, which its other cell then has over; and lowered for
            // one that has a piece over, of which its other cell is then short.
            const std::int32_t next = is_short(state) ? over_at(beyond) : short_at(beyond);
            if (steps_[next].arc != not_reached) continue;
            steps_[next] = {arc, state};
            if (is_short(state) ? takes_one_more(beyond, cell) : spares_one(beyond)) return next;
            queue_.push_back(next);
        }
    }
    return no_state;
}

/// Whether a cell may get a piece, beside the one that the cell which the walk starts from is to get.
bool CountProblem::takes_one_more(std::int32_t cell, std::int32_t start) const {
    return !cells[cell].exact || lack_[cell] > (cell == start ? 1 : 0);
}
bool CountProblem::spares_one(std::int32_t cell) const { return !cells[cell].exact && lack_[cell] < 0; }
bool CountProblem::may_lower(std::int32_t arc) const {
    return !blocked_[arc] && arcs[arc].pieces > arcs[arc].least;
}

/// A walk that fails blocks an arc that was not blocked, so that there are no more tries than arcs, and one.
bool CountProblem::take_walk(std::int32_t cell) {
    for (;;) {
        const std::int32_t end = find_walk(cell);
        if (end == no_state) return false;
        if (apply_walk(end)) return true;
    }
}

/// Raises and lowers the arcs of the walk that ends in a state. If it would lower one arc too often, it
/// undoes itself and blocks that arc.
bool CountProblem::apply_walk(std::int32_t state) {
    std::vector<std::pair<std::int32_t, std::int32_t>> done;
    for (std::int32_t at = state; steps_[at].arc >= 0; at = steps_[at].from) {
        CountArc& arc = arcs[steps_[at].arc];
        const std::int32_t by = is_short(steps_[at].from) ? 1 : -1;
        change(arc, by);
        done.emplace_back(steps_[at].arc, by);
    }
    for (const auto& [arc, by] : done) {
        if (arcs[arc].pieces >= arcs[arc].least) continue;
        blocked_[arc] = 1;
        for (const auto& [undone, step] : done) change(arcs[undone], -step);
        return false;
    }
    return true;
}

bool CountProblem::solve() {
    start();
    for (std::size_t c = 0; c < cells.size(); ++c)
        if (cells[c].exact && lack_[c] < 0) return false;
    if (std::ssize(arcs) > very_many) take_all_both_lacking();
    while (take_both_lacking()) {
    }
    for (std::int32_t c = 0; c < std::ssize(cells); ++c)
        while (lack_[c] > 0) {
            if (take_free(c)) continue;
            std::fill(blocked_.begin(), blocked_.end(), 0);
            if (!take_walk(c)) return false;
        }
    return true;
}

}  // namespace sinew::sqm
