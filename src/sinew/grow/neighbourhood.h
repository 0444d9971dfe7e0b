/// @file neighbourhood.h
/// A string of modules, and who stands beside whom in it.
#pragma once

#include <cstdint>
#include <vector>

#include "sinew/grow/program.h"
#include "sinew/grow/rewrite.h"

namespace sinew::lsystem {

/// A string of modules in flat arrays.
struct Modules {
    std::vector<SymbolId> symbols;
    std::vector<std::size_t> first_argument;
    std::vector<double> arguments;
    std::vector<std::uint64_t> keys;  ///< empty where no rule draws

    std::size_t size() const { return symbols.size(); }
    void clear() { symbols.clear(), first_argument.clear(), arguments.clear(), keys.clear(); }
};

/// Who stands beside whom in a string with branches (section 1.8 of the book): the left neighbour is the next
/// module on the way to the root, the right one is next on the same branch; side branches are passed over.
class StringNeighbourhood : public Neighbourhood {
  public:
    StringNeighbourhood(const Program& program, const Modules& modules)
        : program_(program), modules_(modules) {}

    void prepare();
    /// Places of the string that matching has looked at. Where a pattern has branches it may look at one again and
    /// again; once there are more than `most` nothing matches any more.
    std::int64_t looked_at() const { return looked_at_; }
    void look_at_most(std::int64_t most) { most_ = most; }

    void stand_at(std::size_t module) { at_ = module; }
    bool matches(Rule& rule) override;

  private:
    bool matches_left(Rule& rule) const;
    bool matches_right(Rule& rule, std::size_t pattern, std::size_t at) const;
    std::size_t end_of_branch(std::size_t open) const { return partner_[open]; }
    bool take(Rule& rule, const ContextModule& pattern, std::size_t at) const;
    const Symbol& symbol(std::size_t at) const { return program_.symbols[modules_.symbols[at]]; }

    static constexpr std::int64_t none = -1;
    const Program& program_;
    const Modules& modules_;
    std::vector<std::int64_t> left_;    ///< of each module
    std::vector<std::size_t> partner_;  ///< of each bracket
    std::vector<std::int64_t> ways_;    ///< left neighbours at the brackets that are open
    std::vector<std::size_t> open_;
    std::size_t at_ = 0;
    std::int64_t most_ = INT64_MAX;
    mutable std::int64_t looked_at_ = 0;
};

}  // namespace sinew::lsystem
