#include <fmt/format.h>

#include "sinew/grow/derive.h"
#include "sinew/grow/rewrite.h"

namespace sinew::lsystem {
namespace {

/// The whole string is in memory, twice.
constexpr std::int64_t modules_per_node = 16;

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
};

void StringNeighbourhood::prepare() {
    left_.assign(modules_.size(), none);
    partner_.assign(modules_.size(), 0);
    std::int64_t before = none;
    for (std::size_t i = 0; i < modules_.size(); ++i) {
        const Symbol& one = symbol(i);
        left_[i] = before;
        if (one.command == Command::push) {
            ways_.push_back(before);
            open_.push_back(i);
        } else if (one.command == Command::pop) {
            before = ways_.back();
            partner_[i] = open_.back();
            partner_[open_.back()] = i;
            ways_.pop_back();
            open_.pop_back();
        } else if (!one.ignored) {
            before = static_cast<std::int64_t>(i);
        }
    }
}

bool StringNeighbourhood::take(Rule& rule, const ContextModule& pattern, std::size_t at) const {
    if (modules_.symbols[at] != pattern.symbol) return false;
    std::copy_n(modules_.arguments.begin() + static_cast<std::ptrdiff_t>(modules_.first_argument[at]),
                symbol(at).arity, rule.context_parameters.begin() + pattern.first_parameter);
    return true;
}

bool StringNeighbourhood::matches(Rule& rule) {
    return matches_left(rule) && matches_right(rule, 0, at_ + 1);
}

bool StringNeighbourhood::matches_left(Rule& rule) const {
    std::int64_t at = static_cast<std::int64_t>(at_);
    for (std::size_t i = rule.left.size(); i-- > 0;) {
        at = left_[static_cast<std::size_t>(at)];
        if (at == none || !take(rule, rule.left[i], static_cast<std::size_t>(at))) return false;
    }
    return true;
}

/// Matches rule.right from `pattern` on with the string from `at` on. A branch of the string that the pattern
/// does not name is passed over; a branch of the pattern takes the first branch that fits.
bool StringNeighbourhood::matches_right(Rule& rule, std::size_t pattern, std::size_t at) const {
    while (pattern < rule.right.size()) {
        const Command wanted = program_.symbols[rule.right[pattern].symbol].command;
        while (at < modules_.size() && symbol(at).ignored) ++at;
        const bool at_end = at == modules_.size() || symbol(at).command == Command::pop;
        if (wanted == Command::pop) {  // the rest of this branch does not matter
            int depth = 0;
            for (; at < modules_.size() && !(symbol(at).command == Command::pop && depth == 0); ++at) {
                if (symbol(at).command == Command::push) ++depth;
                if (symbol(at).command == Command::pop) --depth;
            }
            ++at, ++pattern;
            continue;
        }
        if (at_end) return false;
        if (symbol(at).command == Command::push) {
            if (wanted == Command::push && matches_right(rule, pattern + 1, at + 1)) return true;
            at = end_of_branch(at) + 1;
            continue;
        }
        if (wanted == Command::push || !take(rule, rule.right[pattern], at)) return false;
        ++at, ++pattern;
    }
    return true;
}

class ContextDerivation {
  public:
    ContextDerivation(const Grammar& grammar, Program& program, std::int64_t limit, Turtle& turtle,
                      const Progress& progress)
        : grammar_(grammar),
          program_(program),
          rewriter_(grammar, program),
          limit_(limit),
          turtle_(turtle),
          progress_(progress),
          neighbours_(program, now_) {}

    Result<void> run();

  private:
    void start();
    Result<void> step(int number, bool finally);
    void append(SymbolId symbol, const double* arguments, std::uint64_t key);
    void replace(std::int32_t rule, std::uint64_t key);
    std::size_t end_of_branch(std::size_t module) const;
    Result<void> guard(int number) const;
    Result<void> draw();

    const Grammar& grammar_;
    Program& program_;
    Rewriter rewriter_;
    std::int64_t limit_;
    Turtle& turtle_;
    const Progress& progress_;
    Modules now_, next_;
    StringNeighbourhood neighbours_;
    std::int64_t drawn_ = 0, work_ = 0;
};

void ContextDerivation::append(SymbolId symbol, const double* arguments, std::uint64_t key) {
    next_.symbols.push_back(symbol);
    next_.first_argument.push_back(next_.arguments.size());
    next_.arguments.insert(next_.arguments.end(), arguments, arguments + program_.symbols[symbol].arity);
    if (program_.chance) next_.keys.push_back(key);
    if (program_.symbols[symbol].command == Command::draw) ++drawn_;
}

void ContextDerivation::start() {
    const double* arguments = program_.axiom_arguments.data();
    for (std::size_t i = 0; i < program_.axiom.size(); ++i) {
        append(program_.axiom[i], arguments, child_key(mix(program_.seed), i));
        arguments += program_.symbols[program_.axiom[i]].arity;
    }
    std::swap(now_, next_);
}

void ContextDerivation::replace(std::int32_t index, std::uint64_t key) {
    const Rule& rule = program_.rules[index];
    const double* arguments = rewriter_.arguments(rule).data();
    if (rewriter_.error()) return;
    for (std::size_t i = 0; i < rule.successor.size(); ++i) {
        append(rule.successor[i], arguments, child_key(key, i));
        arguments += program_.symbols[rule.successor[i]].arity;
    }
}

/// The bracket that closes the branch a module stands on, or the end.
std::size_t ContextDerivation::end_of_branch(std::size_t module) const {
    for (int depth = 0; module < now_.size(); ++module) {
        const Command command = program_.symbols[now_.symbols[module]].command;
        if (command == Command::push) ++depth;
        if (command == Command::pop && depth-- == 0) break;
    }
    return module;
}

Result<void> ContextDerivation::step(int number, bool finally) {
    next_.clear();
    drawn_ = 0;
    neighbours_.prepare();
    for (std::size_t i = 0; i < now_.size(); ++i) {
        Symbol& symbol = program_.symbols[now_.symbols[i]];
        const double* arguments = now_.arguments.data() + now_.first_argument[i];
        const auto& rules = finally ? symbol.finally : symbol.rules;
        const std::uint64_t key = program_.chance ? now_.keys[i] : 0;
        if (++work_ % 4096 == 0)
            if (auto fine = guard(number); !fine) return fine;
        if (symbol.command == Command::cut) {
            i = end_of_branch(i) - 1;
            continue;
        }
        if (rules.empty()) {
            append(now_.symbols[i], arguments, key);
            continue;
        }
        std::copy_n(arguments, symbol.arity, symbol.parameters.begin());
        neighbours_.stand_at(i);
        const std::uint64_t step_key = child_key(key, static_cast<std::uint64_t>(number));
        const std::int32_t rule = rewriter_.choose(rules, step_key, &neighbours_);
        if (rule < 0)
            append(now_.symbols[i], arguments, key);
        else
            replace(rule, step_key);
        if (rewriter_.error()) return tl::unexpected(*rewriter_.error());
    }
    std::swap(now_, next_);
    return guard(number);
}

Result<void> ContextDerivation::guard(int number) const {
    const auto length = static_cast<std::int64_t>(next_.size());
    const std::string when = fmt::format("after {} of {} steps", number + 1, program_.steps);
    if (drawn_ > count_factor * limit_)
        return too_many_nodes(grammar_, fmt::format("more than {} nodes {}", count_factor * limit_, when),
                              limit_);
    if (length / modules_per_node > limit_ || work_ / work_per_node > limit_)
        return too_much_work(grammar_, fmt::format("more than {} modules {}", work_ + length, when), limit_);
    if (progress_.cancelled()) return Progress::stopped();
    progress_(static_cast<double>(number) / (program_.steps + 1), "grow");
    return {};
}

Result<void> ContextDerivation::draw() {
    for (std::size_t i = 0; i < now_.size(); ++i) {
        const Symbol& symbol = program_.symbols[now_.symbols[i]];
        const double* arguments = now_.arguments.data() + now_.first_argument[i];
        if (symbol.command == Command::none) continue;
        if (symbol.command == Command::cut) {
            i = end_of_branch(i) - 1;
            continue;
        }
        if (!turtle_.obey(symbol.command, arguments, symbol.arity))
            return fail(Error{.message = fmt::format("{} {}", to_text(symbol, arguments), turtle_.wrong()),
                              .file = grammar_.source.name()});
        if (i % 8192 == 0 && progress_.cancelled()) return Progress::stopped();
    }
    return {};
}

Result<void> ContextDerivation::run() {
    start();
    for (int number = 0; number < program_.steps; ++number)
        if (auto done = step(number, false); !done) return done;
    if (auto done = step(program_.steps, true); !done) return done;
    return draw();
}

}  // namespace

Result<void> derive_in_context(const Grammar& grammar, Program& program, std::int64_t limit, Turtle& turtle,
                               const Progress& progress) {
    return ContextDerivation(grammar, program, limit, turtle, progress).run();
}

}  // namespace sinew::lsystem
