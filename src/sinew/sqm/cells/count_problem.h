/// @file count_problem.h
/// How many pieces each arc of one joint is split into, so that its cells have the counts that are asked of
/// them.
///
/// A small integer program: a perfect b-matching in the graph of cells (vertices) and arcs (edges). It is
/// solved by direct steps that keep the pieces alike in length, and then by alternating walks (raise one arc,
/// lower the next, ...) as in matching theory; a walk may use an edge more than once, which stands in for
/// blossoms.
#pragma once

#include <cstdint>
#include <vector>

namespace sinew::sqm {

/// Arcs that must be split alike (one arc, or one and its images under a symmetry).
struct CountArc {
    std::int32_t a = -1,
                 b = -1;      ///< the two cells it adds its pieces to; b = -1: to a alone; b = a: to a twice
    std::int32_t least = 1;   ///< pieces at least
    double length = 1;        ///< for evenness
    std::int32_t pieces = 1;  ///< out
};

struct CountCell {
    std::int32_t target = 4;  ///< pieces round it
    bool exact = false;       ///< exactly that many; otherwise at least
    bool cheap = false;       ///< more vertices cost little here (the path ends in a leaf)
};

class CountProblem {
  public:
    std::vector<CountArc> arcs;
    std::vector<CountCell> cells;

    void clear() { arcs.clear(), cells.clear(); }

    /// Sets the pieces of all arcs. False if there is no solution, or none was found.
    bool solve();

  private:
    struct Step {
        std::int32_t arc = -1, from = -1;  ///< state it came from
    };
    void start();
    bool take_both_lacking();
    bool take_free(std::int32_t cell);
    bool take_walk(std::int32_t cell);
    bool apply_walk(std::int32_t state);
    std::int32_t other(const CountArc& arc, std::int32_t cell) const { return arc.a == cell ? arc.b : arc.a; }
    void change(CountArc& arc, std::int32_t by);
    double room(const CountArc& arc) const { return arc.length / arc.pieces; }

    std::vector<std::int32_t> lack_;  ///< cell -> pieces it still lacks; negative: more than it asked for
    std::vector<std::int32_t> arc_first_, cell_arcs_;  ///< arcs round each cell
    std::vector<Step> steps_;
    std::vector<std::int32_t> queue_;
    std::vector<std::uint8_t> blocked_;  ///< arcs that a walk must not lower again
};

}  // namespace sinew::sqm
