#include "sinew/grow/neighbourhood.h"

#include <algorithm>

namespace sinew::lsystem {

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
        ++looked_at_;
        if (at == none || !take(rule, rule.left[i], static_cast<std::size_t>(at))) return false;
    }
    return true;
}

/// Matches rule.right from `pattern` on with the string from `at` on. A branch of the string that the pattern
/// does not name is passed over; a branch of the pattern takes the first branch that fits.
bool StringNeighbourhood::matches_right(Rule& rule, std::size_t pattern, std::size_t at) const {
    while (pattern < rule.right.size()) {
        if (++looked_at_ > most_) return false;
        const Command wanted = program_.symbols[rule.right[pattern].symbol].command;
        while (at < modules_.size() && symbol(at).ignored) ++at, ++looked_at_;
        const bool at_end = at == modules_.size() || symbol(at).command == Command::pop;
        if (wanted == Command::pop) {  // the rest of this branch does not matter
            int depth = 0;
            for (; at < modules_.size() && !(symbol(at).command == Command::pop && depth == 0);
                 ++at, ++looked_at_) {
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

}  // namespace sinew::lsystem
