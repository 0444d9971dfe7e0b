#include <fmt/format.h>

#include "sinew/grow/derive.h"
#include "sinew/grow/rewrite.h"

namespace sinew::lsystem {
namespace {

constexpr int after_last_step = -1;

/// A successor that is being read.
struct Frame {
    const std::vector<SymbolId>* modules;
    std::size_t next = 0;       ///< module to read
    std::size_t arguments = 0;  ///< where its arguments are in the stack
    std::size_t base = 0;       ///< where this frame's arguments begin
    int steps = 0;              ///< derivation steps left for its modules
    std::uint64_t key = 0;
};

class FreeDerivation {
  public:
    FreeDerivation(const Grammar& grammar, Program& program, std::int64_t limit, std::int64_t expected,
                   Turtle& turtle, const Progress& progress)
        : grammar_(grammar),
          program_(program),
          rewriter_(grammar, program),
          limit_(limit),
          expected_(expected),
          turtle_(turtle),
          progress_(progress) {}

    Result<void> run();

  private:
    Result<void> read_module();
    bool derive(SymbolId id, const Frame& parent, std::uint64_t key);
    bool apply(std::int32_t rule, int steps, std::uint64_t key);
    Result<void> obey(const Symbol& symbol, const double* arguments);
    void cut();
    Result<void> guard();
    std::uint64_t key_at(std::uint64_t key, int steps_left) const {
        return program_.chance ? child_key(key, static_cast<std::uint64_t>(program_.steps - steps_left)) : 0;
    }

    const Grammar& grammar_;
    Program& program_;
    Rewriter rewriter_;
    std::int64_t limit_, expected_;
    Turtle& turtle_;
    const Progress& progress_;
    std::vector<Frame> frames_;
    std::vector<double> arguments_;
    std::int64_t work_ = 0, next_check_ = 0;
};

Result<void> FreeDerivation::run() {
    arguments_ = program_.axiom_arguments;
    frames_.push_back({&program_.axiom, 0, 0, 0, program_.steps, mix(program_.seed)});
    while (!frames_.empty()) {
        Frame& frame = frames_.back();
        if (frame.next == frame.modules->size()) {
            arguments_.resize(frame.base);
            frames_.pop_back();
            continue;
        }
        if (auto done = read_module(); !done) return done;
        if (++work_ > next_check_)
            if (auto done = guard(); !done) return done;
    }
    return {};
}

Result<void> FreeDerivation::read_module() {
    Frame& frame = frames_.back();
    const SymbolId id = (*frame.modules)[frame.next];
    const Symbol& symbol = program_.symbols[id];
    const double* arguments = arguments_.data() + frame.arguments;
    const std::uint64_t key = program_.chance ? child_key(frame.key, frame.next) : 0;
    ++frame.next;
    frame.arguments += static_cast<std::size_t>(symbol.arity);
    if (derive(id, frame, key)) return {};
    if (rewriter_.error()) return tl::unexpected(*rewriter_.error());
    return obey(symbol, arguments);
}

/// False where the module stays what it is to the end. May change frames_.
bool FreeDerivation::derive(SymbolId id, const Frame& parent, std::uint64_t key) {
    Symbol& symbol = program_.symbols[id];
    if ((symbol.rules.empty() && symbol.finally.empty()) || parent.steps == after_last_step) return false;
    std::copy_n(arguments_.begin() + static_cast<std::ptrdiff_t>(parent.arguments) - symbol.arity,
                symbol.arity, symbol.parameters.begin());
    int steps = parent.steps;
    while (!symbol.rules.empty() && steps > 0) {
        const std::uint64_t step_key = key_at(key, steps--);
        const std::int32_t rule = rewriter_.choose(symbol.rules, step_key);
        if (rule >= 0) return apply(rule, steps, step_key);
        if (!symbol.chance || rewriter_.error()) break;  // what does not fit now never will
        if (++work_ / work_per_node > limit_) break;     // the guard will say so
    }
    if (symbol.finally.empty() || rewriter_.error()) return false;
    const std::uint64_t step_key = key_at(key, 0);
    const std::int32_t rule = rewriter_.choose(symbol.finally, step_key);
    return rule >= 0 && apply(rule, after_last_step, step_key);
}

bool FreeDerivation::apply(std::int32_t index, int steps, std::uint64_t key) {
    const Rule& rule = program_.rules[index];
    // A frame that has been read is not kept, so that A -> F A needs no stack.
    if (frames_.back().next == frames_.back().modules->size()) {
        arguments_.resize(frames_.back().base);
        frames_.pop_back();
    }
    const auto values = rewriter_.arguments(rule);
    if (rewriter_.error()) return false;
    const std::size_t base = arguments_.size();
    arguments_.insert(arguments_.end(), values.begin(), values.end());
    frames_.push_back({&rule.successor, 0, base, base, steps, key});
    return true;
}

Result<void> FreeDerivation::obey(const Symbol& symbol, const double* arguments) {
    if (symbol.command == Command::none) return {};
    if (symbol.command == Command::cut) return cut(), Result<void>{};
    if (turtle_.obey(symbol.command, arguments, symbol.arity)) return {};
    return fail(Error{.message = fmt::format("{} {}", to_text(symbol, arguments), turtle_.wrong()),
                      .file = grammar_.source.name()});
}

/// Passes over all that follows up to the end of the branch.
void FreeDerivation::cut() {
    for (int depth = 0; !frames_.empty();) {
        Frame& frame = frames_.back();
        for (; frame.next < frame.modules->size(); ++frame.next) {
            const Symbol& symbol = program_.symbols[(*frame.modules)[frame.next]];
            if (symbol.command == Command::push) ++depth;
            if (symbol.command == Command::pop && depth-- == 0) return;
            frame.arguments += static_cast<std::size_t>(symbol.arity);
        }
        arguments_.resize(frame.base);
        frames_.pop_back();
    }
}

/// Called now and then.
Result<void> FreeDerivation::guard() {
    next_check_ = work_ + 8192;
    if (turtle_.node_count() > limit_) {
        if (turtle_.node_count() > count_factor * limit_)
            return too_many_nodes(grammar_, "more than " + nodes_text(count_factor * limit_), limit_);
    } else if (work_ / work_per_node > limit_) {
        return too_much_work(grammar_, fmt::format("more than {} modules", work_), limit_);
    }
    if (static_cast<std::int64_t>(frames_.size()) > limit_ + work_per_node)
        return fail(Error{.message = fmt::format("modules stand inside each other {} deep", frames_.size()),
                          .cure = "take fewer steps or raise the limit",
                          .file = grammar_.source.name()});
    if (progress_.cancelled()) return Progress::stopped();
    if (expected_ > 0)
        progress_(static_cast<double>(turtle_.node_count()) / static_cast<double>(expected_), "grow");
    return {};
}

}  // namespace

Result<void> derive_free(const Grammar& grammar, Program& program, std::int64_t limit, std::int64_t expected,
                         Turtle& turtle, const Progress& progress) {
    return FreeDerivation(grammar, program, limit, expected, turtle, progress).run();
}

std::string nodes_text(std::int64_t count) { return fmt::format("{} node{}", count, count == 1 ? "" : "s"); }

tl::unexpected<Error> too_many_nodes(const Grammar& grammar, std::string count, std::int64_t limit) {
    return fail(Error{
        .message = fmt::format("the skeleton would have {}, and the limit is {}", count, nodes_text(limit)),
        .cure = "take fewer steps or raise the limit",
        .file = grammar.source.name()});
}

tl::unexpected<Error> too_much_work(const Grammar& grammar, std::string count, std::int64_t limit) {
    return fail(Error{.message = fmt::format("growing would take {}, and a limit of {} allows {}", count,
                                             nodes_text(limit), limit * work_per_node),
                      .cure = "take fewer steps or raise the limit",
                      .file = grammar.source.name()});
}

}  // namespace sinew::lsystem
