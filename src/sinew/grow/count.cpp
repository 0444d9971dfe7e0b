#include "sinew/grow/count.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <vector>

#include "sinew/grow/rewrite.h"

namespace sinew::lsystem {
namespace {

std::uint64_t sum(std::uint64_t a, std::uint64_t b) { return a > countless - b ? countless : a + b; }

/// What a module comes to. The pen's place has a node or not when the module begins; both are counted.
struct Future {
    std::uint64_t modules = 1;
    bool cuts = false;   ///< a % ends the branch
    bool moves = false;  ///< the pen ends at another place than it began
    struct Case {
        std::uint64_t nodes = 0;
        bool node_at_start = false;  ///< the place where it began has a node in the end
        bool node_at_end = false;    ///< so has the place where it ended
    } with[2];                       ///< [1]: a node was there before
};

/// Reads a sequence of modules as the turtle would, but only counts.
class Tally {
  public:
    Tally() {
        for (int before : {0, 1}) pens_[before].has_node.push_back(before == 1);
    }
    bool skips() const { return cut_at_ >= 0; }
    bool at_root() const { return depth_ == 0; }
    void push() {
        ++depth_;
        for (Pen& pen : pens_) pen.stack.push_back(pen.place);
    }
    void pop() {
        if (cut_at_ == depth_) cut_at_ = -1;
        --depth_;
        for (Pen& pen : pens_) pen.place = pen.stack.back(), pen.stack.pop_back();
    }
    void add(const Future& future);
    Future result() const;

  private:
    struct Pen {
        std::vector<char> has_node;  ///< of each place
        std::vector<std::size_t> stack;
        std::size_t place = 0;
        std::uint64_t nodes = 0;
    };
    Pen pens_[2];
    std::uint64_t modules_ = 1;
    int depth_ = 0, cut_at_ = -1;
};

void Tally::add(const Future& future) {
    if (skips()) return;
    modules_ = sum(modules_, future.modules);
    for (Pen& pen : pens_) {
        const Future::Case& c = future.with[static_cast<int>(pen.has_node[pen.place])];
        pen.nodes = sum(pen.nodes, c.nodes);
        pen.has_node[pen.place] = c.node_at_start;
        if (!future.moves) continue;
        pen.place = pen.has_node.size();
        pen.has_node.push_back(c.node_at_end);
    }
    if (future.cuts) cut_at_ = depth_;
}

Future Tally::result() const {
    Future result{.modules = modules_, .cuts = cut_at_ == 0, .moves = pens_[0].place != 0};
    for (int before : {0, 1}) {
        const Pen& pen = pens_[before];
        result.with[before] = {pen.nodes, pen.has_node[0] != 0, pen.has_node[pen.place] != 0};
    }
    return result;
}

/// What the turtle does with a module that is not replaced any more.
Future future_of(Command command) {
    Future result;
    result.with[0] = {0, false, false};
    result.with[1] = {0, true, true};
    if (command == Command::draw) {
        result.moves = true;
        result.with[0] = {2, true, true};
        result.with[1] = {1, true, true};
    }
    if (command == Command::move) {
        result.moves = true;
        result.with[0].node_at_end = result.with[1].node_at_end = false;
    }
    if (command == Command::node) result.with[0] = {1, true, true};
    if (command == Command::cut) result.cuts = true;
    return result;
}

/// Which parameters of each symbol decide anything.
std::vector<std::vector<char>> deciding_parameters(const Grammar& grammar, const Program& program) {
    std::vector<std::vector<char>> decides;
    for (const Symbol& symbol : program.symbols) decides.emplace_back(symbol.arity, 0);
    const auto mark = [&](const Production& production, SymbolId predecessor, const Text& formula) {
        bool changed = false;
        const auto names = names_in(formula);
        const auto& parameters = production.predecessor.parameters;
        for (std::size_t i = 0; i < parameters.size(); ++i)
            if (!decides[predecessor][i] && std::binary_search(names.begin(), names.end(), parameters[i]))
                decides[predecessor][i] = changed = true;
        return changed;
    };
    for (bool changed = true; changed;) {
        changed = false;
        for (SymbolId id = 0; id < std::ssize(program.symbols); ++id)
            for (const auto* rules : {&program.symbols[id].rules, &program.symbols[id].finally})
                for (std::int32_t index : *rules) {
                    const Rule& rule = program.rules[index];
                    const Production& production = grammar.productions[rule.production];
                    changed |= mark(production, id, production.condition);
                    for (std::size_t m = 0; m < rule.successor.size(); ++m)
                        for (std::int32_t k = 0; k < program.symbols[rule.successor[m]].arity; ++k)
                            if (decides[rule.successor[m]][k])
                                changed |= mark(production, id, production.successor[m].arguments[k]);
                }
    }
    return decides;
}

/// Modules with one future, and what they are replaced by.
struct Kind {
    bool replaced = false;
    Command command = Command::none;
    std::vector<std::pair<SymbolId, std::size_t>> successor;  ///< with indices of kinds, one step later
};

class Counter {
  public:
    Counter(const Grammar& grammar, Program& program, const Progress& progress)
        : program_(program),
          rewriter_(grammar, program),
          progress_(progress),
          decides_(deciding_parameters(grammar, program)) {}

    std::optional<Count> run();

  private:
    using Key = std::pair<SymbolId, std::vector<double>>;
    using Level = std::map<Key, std::size_t>;

    std::size_t kind_of(SymbolId symbol, std::span<const double> arguments, Level& level);
    std::vector<std::pair<SymbolId, std::size_t>> kinds_of(const std::vector<SymbolId>& symbols,
                                                           std::span<const double> arguments, Level& level);
    void derive(const Level& from, int steps_left, Level& next, Level& last);
    /// Within a level, which may be as long as all that is allowed.
    bool gives_up() const {
        return kinds_.size() > most_kinds || successors_ > most_successors || progress_.cancelled();
    }
    Future future(const std::vector<std::pair<SymbolId, std::size_t>>& modules) const;

    Program& program_;
    Rewriter rewriter_;
    const Progress& progress_;
    std::vector<std::vector<char>> decides_;
    std::size_t successors_ = 0;  ///< modules in the kinds' successors, all together
    std::vector<Kind> kinds_;     ///< those of later steps come later
    std::vector<Future> futures_;
    bool lost_ = false;  ///< something is not finite: growing will say where
};

std::size_t Counter::kind_of(SymbolId symbol, std::span<const double> arguments, Level& level) {
    Key key{symbol, {}};
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        if (!decides_[symbol][i]) continue;
        key.second.push_back(arguments[i]);
        lost_ = lost_ || !std::isfinite(arguments[i]);
    }
    const auto [entry, added] = level.try_emplace(std::move(key), kinds_.size());
    if (added) kinds_.push_back({.command = program_.symbols[symbol].command});
    return entry->second;
}

std::vector<std::pair<SymbolId, std::size_t>> Counter::kinds_of(const std::vector<SymbolId>& symbols,
                                                                std::span<const double> arguments,
                                                                Level& level) {
    std::vector<std::pair<SymbolId, std::size_t>> result;
    for (SymbolId symbol : symbols) {
        const auto arity = static_cast<std::size_t>(program_.symbols[symbol].arity);
        result.emplace_back(symbol, kind_of(symbol, arguments.first(arity), level));
        arguments = arguments.subspan(arity);
    }
    return result;
}

/// Replaces each kind of a level once. What is replaced before the last step goes to `next`, after it to
/// `last`.
void Counter::derive(const Level& from, int steps_left, Level& next, Level& last) {
    for (const auto& [key, index] : from) {
        if (gives_up()) return;
        Symbol& symbol = program_.symbols[key.first];
        std::size_t deciding = 0;
        for (std::int32_t i = 0; i < symbol.arity; ++i)
            symbol.parameters[i] = decides_[key.first][i] ? key.second[deciding++] : 1;
        std::int32_t rule = steps_left > 0 ? rewriter_.choose(symbol.rules, 0) : -1;
        Level& level = rule >= 0 ? next : last;
        if (rule < 0) rule = rewriter_.choose(symbol.finally, 0);
        if (rule < 0 || rewriter_.error()) continue;
        const Rule& chosen = program_.rules[rule];
        const auto arguments = chosen.arguments ? chosen.arguments.values() : std::span<const double>();
        auto successor = kinds_of(chosen.successor, arguments, level);
        successors_ += successor.size();
        kinds_[index].successor = std::move(successor);
        kinds_[index].replaced = true;
    }
}

Future Counter::future(const std::vector<std::pair<SymbolId, std::size_t>>& modules) const {
    Tally tally;
    for (const auto& [symbol, kind] : modules) {
        if (program_.symbols[symbol].command == Command::push) tally.push();
        if (program_.symbols[symbol].command == Command::pop) tally.pop();
        tally.add(futures_[kind]);
    }
    return tally.result();
}

std::optional<Count> Counter::run() {
    Level now, next, last;
    const auto axiom = kinds_of(program_.axiom, program_.axiom_arguments, now);
    for (int steps_left = program_.steps; !now.empty(); --steps_left) {
        // Kinds that are not replaced by a rule now never will be: only the last productions wait for them.
        derive(now, steps_left, next, last);
        if (lost_ || rewriter_.error() || gives_up()) return {};
        now = std::exchange(next, {});
    }
    futures_.resize(kinds_.size());
    for (std::size_t i = kinds_.size(); i-- > 0;)
        futures_[i] = kinds_[i].replaced ? future(kinds_[i].successor) : future_of(kinds_[i].command);
    const Future all = future(axiom);
    return Count{all.with[0].nodes, all.modules};
}

}  // namespace

std::optional<Count> count_nodes(const Grammar& grammar, Program& program, const Progress& progress) {
    if (program.chance || program.context) return {};
    return Counter(grammar, program, progress).run();
}

}  // namespace sinew::lsystem
