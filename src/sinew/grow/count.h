/// @file count.h
/// How large a skeleton will be, without growing it.
#pragma once

#include <cstdint>
#include <optional>

#include "sinew/base/progress.h"
#include "sinew/grow/program.h"

namespace sinew::lsystem {

struct Count {
    std::uint64_t nodes = 0;    ///< of the document
    std::uint64_t modules = 0;  ///< handed to the turtle, and rules applied: what growing takes
};

/// Largest count that is told apart from larger ones.
inline constexpr std::uint64_t countless = UINT64_MAX;

/// Kinds of modules that are told apart, and modules that they are replaced by, at most: beyond, nothing is counted.
inline constexpr std::size_t most_kinds = 1 << 20, most_successors = 1 << 22;

/// Counts exactly for a grammar without chance and without contexts; nothing for others, and for those whose
/// conditions look at too many different numbers to be counted at once.
///
/// Modules that have the same symbol, the same steps to go, and the same values of those parameters that
/// decide anything (in conditions, or in what conditions look at later) have the same future: it is counted
/// once. So figure 2.6 takes three modules a step, however large the tree.
std::optional<Count> count_nodes(const Grammar& grammar, Program& program, const Progress& progress = {});

}  // namespace sinew::lsystem
