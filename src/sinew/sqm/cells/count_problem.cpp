#include "sinew/sqm/cells/count_problem.h"

#include <algorithm>
#include <numeric>

namespace sinew::sqm {

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
        if (lacking && (!best || room(arc) > room(*best) * (1 + 1e-9))) best = &arc;
    }
    if (best) change(*best, 1);
    return best != nullptr;
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
        if (!best || cheap > best_cheap || (cheap == best_cheap && room(arc) > room(*best) * (1 + 1e-9))) {
            best = &arc;
            best_cheap = cheap;
        }
    }
    if (best) change(*best, 1);
    return best != nullptr;
}

/// States of the search: 2 cell (it lacks a piece) and 2 cell + 1 (it has one too many).
bool CountProblem::take_walk(std::int32_t cell) {
    for (std::size_t attempt = 0; attempt <= arcs.size(); ++attempt) {
        steps_.assign(2 * cells.size(), {});
        steps_[2 * cell].arc = -2;
        queue_.assign(1, 2 * cell);
        std::int32_t end = -1;
        for (std::size_t head = 0; head < queue_.size() && end < 0; ++head) {
            const std::int32_t state = queue_[head], at = state / 2;
            const bool lacks = state % 2 == 0;
            for (std::int32_t i = arc_first_[at]; i < arc_first_[at + 1] && end < 0; ++i) {
                const std::int32_t arc = cell_arcs_[i], beyond = other(arcs[arc], at);
                if (!lacks && (blocked_[arc] || arcs[arc].pieces <= arcs[arc].least)) continue;
                if (beyond < 0) {
                    steps_.push_back({arc, state});  // an arc of one cell: the walk ends in the open
                    end = static_cast<std::int32_t>(steps_.size()) - 1;
                    break;
                }
                const std::int32_t next = 2 * beyond + (lacks ? 1 : 0);
                if (steps_[next].arc != -1) continue;
                steps_[next] = {arc, state};
                const bool settled = lacks
                                         ? (!cells[beyond].exact || lack_[beyond] > (beyond == cell ? 1 : 0))
                                         : (!cells[beyond].exact && lack_[beyond] < 0);
                if (settled)
                    end = next;
                else
                    queue_.push_back(next);
            }
        }
        if (end < 0) return false;
        if (apply_walk(end)) return true;
    }
    return false;
}

/// Raises and lowers the arcs of the walk that ends in a state. If it would lower one arc too often, it
/// undoes itself and blocks that arc.
bool CountProblem::apply_walk(std::int32_t state) {
    std::vector<std::pair<std::int32_t, std::int32_t>> done;
    for (std::int32_t at = state; steps_[at].arc >= 0; at = steps_[at].from) {
        CountArc& arc = arcs[steps_[at].arc];
        const std::int32_t by = steps_[at].from % 2 == 0 ? 1 : -1;
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
