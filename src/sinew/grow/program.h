/// @file program.h
/// A grammar made ready to run: symbols are numbers, formulas are compiled, settings have values.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sinew/base/result.h"
#include "sinew/base/vec.h"
#include "sinew/grow/formula.h"
#include "sinew/grow/grammar.h"
#include "sinew/grow/options.h"
#include "sinew/grow/random.h"
#include "sinew/grow/turtle_symbols.h"

namespace sinew::lsystem {

using SymbolId = std::int32_t;

/// A symbol together with how many arguments it has: F and F(l) are two.
struct Symbol {
    std::string name;
    std::int32_t arity = 0;
    Command command = Command::none;
    bool ignored = false;  ///< contexts look through it
    bool chance = false;   ///< a weight or a condition of its rules may come out otherwise at each step
    std::vector<std::int32_t> rules;    ///< those that may replace it, in the order in which they are tried
    std::vector<std::int32_t> finally;  ///< the same after the last step
    std::vector<double> parameters;     ///< what its rules' formulas see: put the module's arguments here
};

/// A module of a context and where its arguments go in Rule::context_parameters.
struct ContextModule {
    SymbolId symbol = 0;
    std::int32_t first_parameter = 0;
};

struct Rule {
    std::vector<ContextModule> left, right;
    std::vector<double> context_parameters;
    Formula condition, weight;  ///< false: none
    Formula arguments;          ///< of all modules of the successor, one after the other
    std::vector<SymbolId> successor;
    std::int32_t production = 0;  ///< index in Grammar::productions

    bool has_context() const { return !left.empty() || !right.empty(); }
};

/// What a symbol without argument stands for, and how the turtle starts.
struct TurtleDefaults {
    double angle = 90, length = 1, radius = 0.1, thinning = 0.70710678118654752;
    Vec3 tropism = Vec3(0, 0, -1);
    double bending = 0;
};

struct Program {
    std::vector<Symbol> symbols;
    std::vector<Rule> rules;
    std::vector<SymbolId> axiom;
    std::vector<double> axiom_arguments;
    std::vector<double> constants;  ///< in the order of Grammar::constants
    TurtleDefaults turtle;
    int steps = 1;
    std::uint64_t seed = 1;
    bool context = false;                                         ///< some rule looks at neighbours
    bool chance = false;                                          ///< some rule draws random numbers
    std::unique_ptr<Random> random = std::make_unique<Random>();  ///< where formulas draw from
};

/// Checks and compiles a grammar with the constants, steps and seed of the options. Refers to the grammar.
Result<Program> compile(const Grammar& grammar, const GrowOptions& options = {});

/// The text of a module for messages, such as F(2.5).
std::string to_text(const Symbol& symbol, const double* arguments);

}  // namespace sinew::lsystem
