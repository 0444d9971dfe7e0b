/// @file rewrite.h
/// Which rule replaces a module, and with what.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sinew/base/result.h"
#include "sinew/grow/program.h"

namespace sinew::lsystem {

/// Looks at the neighbours of the module that is being replaced, and puts their arguments where the rule sees
/// them.
class Neighbourhood {
  public:
    virtual ~Neighbourhood() = default;
    virtual bool matches(Rule& rule) = 0;
};

class Rewriter {
  public:
    Rewriter(const Grammar& grammar, Program& program) : grammar_(grammar), program_(program) {}

    /// The rule for a module whose arguments are in Symbol::parameters. The first rule that fits (context,
    /// condition) wins; if it has a weight, one is drawn among it and the other rules with weights that fit.
    /// @param rules  candidates in order
    /// @param key    what the module's random stream begins with
    /// @return -1 where none fits, or where error() is set
    std::int32_t choose(std::span<const std::int32_t> rules, std::uint64_t key,
                        Neighbourhood* neighbours = nullptr);

    /// Arguments of the rule's successor, good until the next call; empty where error() is set.
    std::span<const double> arguments(const Rule& rule);

    const std::optional<Error>& error() const { return error_; }

  private:
    bool fits(Rule& rule, Neighbourhood* neighbours);
    double weight(const Rule& rule);
    void wrong(const Text& place, double value, const char* expected);

    const Grammar& grammar_;
    Program& program_;
    std::vector<std::pair<std::int32_t, double>> weighted_;
    std::optional<Error> error_;
};

}  // namespace sinew::lsystem
