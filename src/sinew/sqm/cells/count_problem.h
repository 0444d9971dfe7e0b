/// @file count_problem.h
/// How many pieces each arc of one joint is split into, so that its cells have the counts that are asked of
/// them.
///
/// A small integer program: a perfect b-matching in the graph of cells (vertices) and arcs (edges), where an
/// edge may be taken any number of times from its least on (A. Schrijver, "Combinatorial Optimization", 2003,
/// chapter 31). It is solved by direct steps that keep the pieces alike in length, and then, for what is
/// still lacking, by alternating walks: one arc is raised, the next one lowered, and so on, to a cell that
/// takes the piece or gives it.
///
/// Walks may come to a cell twice, once short of a piece and once with one over, which is how they go round
/// cycles of odd length. Matchings that take an edge at most once need J. Edmonds' blossoms for that ("Paths,
/// trees, and flowers", 1965); here an arc may be raised as often as a walk meets it, and all that can go
/// wrong is that it is lowered twice with one piece to spare. Then it is not lowered at all by the next try,
/// of which there are at most as many as arcs. That this finds a solution wherever there is one is not
/// proved; the test compares it with trying everything.
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
    void take_all_both_lacking();
    bool take_free(std::int32_t cell);
    bool take_walk(std::int32_t cell);
    std::int32_t find_walk(std::int32_t cell);
    bool apply_walk(std::int32_t state);
    bool takes_one_more(std::int32_t cell, std::int32_t start) const;
    bool spares_one(std::int32_t cell) const;
    bool may_lower(std::int32_t arc) const;
    std::int32_t other(const CountArc& arc, std::int32_t cell) const { return arc.a == cell ? arc.b : arc.a; }
    void change(CountArc& arc, std::int32_t by);
    double piece_length(const CountArc& arc) const { return arc.length / arc.pieces; }

    std::vector<std::int32_t> lack_;  ///< cell -> pieces it still lacks; negative: more than it asked for
    std::vector<std::int32_t> arc_first_, cell_arcs_;  ///< arcs round each cell
    std::vector<Step> steps_;
    std::vector<std::int32_t> queue_;
    std::vector<std::uint8_t> blocked_;  ///< arcs that a walk must not lower again
};

}  // namespace sinew::sqm
