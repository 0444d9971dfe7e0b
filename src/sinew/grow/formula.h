/// @file formula.h
/// Arithmetic of a .lsys file: checked once, compiled once by muParser, evaluated many times.
///
/// Operators, from weak to strong: ?: || && == != < <= > >= + - * / ^, and - + ! in front. Angles are in
/// degrees. Functions: sin cos tan atan2 sqrt exp log abs sign floor ceil round mod min max random normal.
/// Constant: pi.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sinew/base/result.h"
#include "sinew/grow/random.h"
#include "sinew/grow/source.h"

namespace mu {
class Parser;
}

namespace sinew::lsystem {

/// Names that formulas may use and what they stand for when the formula is evaluated.
struct Variable {
    std::string name;
    const double* value = nullptr;
};

/// One formula, or several that are evaluated together. Not for two threads at once: muParser keeps its stack
/// inside.
class Formula {
  public:
    Formula();
    Formula(Formula&&) noexcept;
    Formula& operator=(Formula&&) noexcept;
    ~Formula();

    double value() const { return values()[0]; }
    /// Good until the next evaluation.
    std::span<const double> values() const;
    explicit operator bool() const { return count_ > 0; }

  private:
    friend class FormulaCompiler;
    std::vector<std::unique_ptr<mu::Parser>>
        parsers_;  ///< more than one where muParser takes no text that long
    mutable std::vector<double> values_;
    std::size_t count_ = 0;
};

class FormulaCompiler {
  public:
    /// @param source  for the places of errors; it and `random` must outlive the formulas
    FormulaCompiler(const Source& source, Random& random);
    ~FormulaCompiler();
    FormulaCompiler(const FormulaCompiler&) = delete;
    FormulaCompiler& operator=(const FormulaCompiler&) = delete;

    /// Makes a constant known to the formulas compiled from now on.
    void define(const std::string& name, double value) { constants_[name] = value; }
    bool is_constant(const std::string& name) const { return constants_.contains(name); }

    /// Compiles formulas whose values() come in this order. Fails with the place and what was expected there.
    Result<Formula> compile(std::span<const Text> formulas, std::span<const Variable> variables) const;
    Result<Formula> compile(const Text& formula, std::span<const Variable> variables) const {
        return compile(std::span(&formula, 1), variables);
    }

  private:
    Result<void> check_names(const Text& formula, std::span<const Variable> variables) const;
    Result<std::unique_ptr<mu::Parser>> parse(const std::string& text, std::span<const Variable> variables,
                                              const Text& place, std::size_t expected) const;

    const Source& source_;
    std::unique_ptr<mu::Parser> functions_;
    std::map<std::string, double, std::less<>> constants_;
};

bool is_function(std::string_view name);
/// Names that stand in a formula (functions too), each once.
std::vector<std::string> names_in(const Text& formula);

}  // namespace sinew::lsystem
