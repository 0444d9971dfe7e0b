/// @file derive.h
/// From the axiom to the last step, with each module of the result handed to a turtle.
#pragma once

#include <cstdint>
#include <string>

#include "sinew/base/progress.h"
#include "sinew/base/result.h"
#include "sinew/grow/program.h"
#include "sinew/grow/turtle.h"

namespace sinew::lsystem {

/// Derivation of a grammar without contexts, depth first: a module's whole future is derived before its right
/// neighbour's, so that memory is the turtle's and the depth of the tree, and time is linear in the rules
/// applied.
/// @param expected  nodes that will come, for the progress; 0 where nobody knows
Result<void> derive_free(const Grammar& grammar, Program& program, std::int64_t limit, std::int64_t expected,
                         Turtle& turtle, const Progress& progress);

/// Derivation of any grammar, step by step on the whole string of modules.
Result<void> derive_in_context(const Grammar& grammar, Program& program, std::int64_t limit, Turtle& turtle,
                               const Progress& progress);

/// A skeleton may take so many modules and rules for each node of the limit; more is a grammar that runs
/// away.
inline constexpr std::int64_t work_per_node = 64;

/// Counting goes on to so many times the limit, to say how far the skeleton would have gone.
inline constexpr std::int64_t count_factor = 4;

/// "1 node", "2 nodes".
std::string nodes_text(std::int64_t count);

/// The errors of the guard.
/// @param count  such as "12 nodes"
tl::unexpected<Error> too_many_nodes(const Grammar& grammar, std::string count, std::int64_t limit);
tl::unexpected<Error> too_much_work(const Grammar& grammar, std::string count, std::int64_t limit);

}  // namespace sinew::lsystem
