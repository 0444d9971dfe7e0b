/// @file grammar.h
/// An L-system as it was written: axiom, constants, productions and settings (Prusinkiewicz, Lindenmayer,
/// "The Algorithmic Beauty of Plants", 1990, chapters 1 and 2). The language is explained in
/// docs/lsystems.md.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sinew/base/result.h"
#include "sinew/grow/source.h"
#include "sinew/skeleton/document.h"

namespace sinew {

/// `name = formula  # remark`
struct GrowConstant {
    std::string name;
    lsystem::Text formula;
    double value = 0;    ///< with the file's own constants and seed
    std::string remark;  ///< the comment on its line, for people
};

namespace lsystem {

/// A symbol with arguments, as in an axiom or a successor. Brackets are modules without arguments.
struct Module {
    Text symbol;
    std::vector<Text> arguments;
};

/// A symbol with names for its parameters, as in a predecessor or a context.
struct Pattern {
    Text symbol;
    std::vector<std::string> parameters;
};

/// `left < predecessor > right : condition ->(weight) successor`
struct Production {
    std::vector<Pattern> left, right;  ///< right may hold brackets
    Pattern predecessor;
    Text condition, weight;  ///< empty: none
    std::vector<Module> successor;
    bool finally = false;  ///< applied once, after the last step
};

/// `%word formula, formula ...`
struct Setting {
    Text word;
    std::vector<Text> formulas;
};

}  // namespace lsystem

/// What parse() makes and grow() takes. Sound: all names are known and all formulas compile.
struct Grammar {
    std::vector<GrowConstant> constants;
    std::vector<lsystem::Module> axiom;
    std::vector<lsystem::Production> productions;
    std::vector<lsystem::Setting> settings;
    std::vector<std::string> ignored;  ///< symbols that contexts look through
    std::string unit;
    Symmetry symmetry;
    int steps = 1;           ///< with the file's own constants
    std::uint64_t seed = 1;  ///< likewise
    lsystem::Source source;
};

/// Reads an L-system.
/// @param text  the content of a `.lsys` file
/// @param name  its name, for errors
/// Fails with line, column and what was expected there.
Result<Grammar> parse_grammar(std::string_view text, std::string name);

}  // namespace sinew
