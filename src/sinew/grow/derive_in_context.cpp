#include <fmt/format.h>

#include "sinew/grow/derive.h"
#include "sinew/grow/neighbourhood.h"
#include "sinew/grow/rewrite.h"

namespace sinew::lsystem {
namespace {

/// The whole string is in memory, twice.
constexpr std::int64_t modules_per_node = 16;

/// Places that contexts may look at for each node of the limit, over all steps.
constexpr std::int64_t looks_per_node = 4 * work_per_node;

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
          neighbours_(program, now_) {
        neighbours_.look_at_most(looks_per_node * limit);
    }

    Result<void> run();

  private:
    void start();
    Result<void> step(int number, bool finally);
    bool stands_still() const;
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
        if (++work_ % 4096 == 0 || neighbours_.looked_at() > looks_per_node * limit_)
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

/// Did the last step change nothing? Then no later one will, unless chance has a say.
bool ContextDerivation::stands_still() const {
    return !program_.chance && now_.symbols == next_.symbols && now_.arguments == next_.arguments;
}

Result<void> ContextDerivation::guard(int number) const {
    const auto length = static_cast<std::int64_t>(next_.size());
    const std::string when = fmt::format("after {} of {} steps", number + 1, program_.steps);
    if (drawn_ > count_factor * limit_)
        return too_many_nodes(
            grammar_, fmt::format("more than {} {}", nodes_text(count_factor * limit_), when), limit_);
    if (length / modules_per_node > limit_ || work_ / work_per_node > limit_)
        return too_much_work(grammar_, fmt::format("more than {} modules {}", work_ + length, when), limit_);
    if (neighbours_.looked_at() > looks_per_node * limit_)
        return too_much_work(
            grammar_, fmt::format("contexts that look at more than {} modules", looks_per_node * limit_),
            limit_);
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
    for (int number = 0; number < program_.steps; ++number) {
        if (number > limit_)
            return fail(Error{.message = fmt::format("{} steps with contexts are more than the limit of {}",
                                                     program_.steps, nodes_text(limit_)),
                              .cure = "take fewer steps or raise the limit",
                              .file = grammar_.source.name()});
        if (auto done = step(number, false); !done) return done;
        if (stands_still()) break;
    }
    if (auto done = step(program_.steps, true); !done) return done;
    return draw();
}

}  // namespace

Result<void> derive_in_context(const Grammar& grammar, Program& program, std::int64_t limit, Turtle& turtle,
                               const Progress& progress) {
    return ContextDerivation(grammar, program, limit, turtle, progress).run();
}

}  // namespace sinew::lsystem
