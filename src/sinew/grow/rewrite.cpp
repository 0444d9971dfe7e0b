#include "sinew/grow/rewrite.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace sinew::lsystem {

void Rewriter::wrong(const Text& place, double value, const char* expected) {
    if (error_) return;
    if (std::isnan(value)) value = std::numeric_limits<double>::quiet_NaN();  // of any sign
    error_ =
        grammar_.source
            .error(place.offset, fmt::format("the formula '{}' gives {} while growing", place.text, value),
                   fmt::format("expected {}", expected))
            .value();
}

bool Rewriter::fits(Rule& rule, Neighbourhood* neighbours) {
    if (rule.has_context() && !(neighbours && neighbours->matches(rule))) return false;
    if (!rule.condition) return true;
    const double truth = rule.condition.value();
    if (std::isnan(truth)) wrong(grammar_.productions[rule.production].condition, truth, "true or false");
    return truth != 0;
}

double Rewriter::weight(const Rule& rule) {
    const double weight = rule.weight.value();
    if (!(weight >= 0) || std::isinf(weight))
        wrong(grammar_.productions[rule.production].weight, weight, "a weight of 0 or more");
    return weight;
}

std::int32_t Rewriter::choose(std::span<const std::int32_t> rules, std::uint64_t key,
                              Neighbourhood* neighbours) {
    if (program_.chance) *program_.random = Random(key);
    std::int32_t otherwise = -1;
    double sum = 0;
    weighted_.clear();
    for (std::int32_t index : rules) {
        Rule& rule = program_.rules[index];
        // The rules with context come first, and draw among themselves.
        if (!weighted_.empty() && program_.rules[weighted_[0].first].has_context() != rule.has_context()) {
            if (sum > 0) break;
            weighted_.clear();
        }
        if (!fits(rule, neighbours) || error_) continue;
        if (rule.weight) {
            weighted_.emplace_back(index, weight(rule));
            sum += weighted_.back().second;
        } else if (weighted_.empty()) {
            return index;
        } else if (otherwise < 0) {
            otherwise = index;
        }
    }
    if (error_) return -1;
    if (!(sum > 0)) return otherwise;
    double left = program_.random->uniform() * sum;
    std::int32_t chosen = -1;
    for (const auto& [rule, weight] : weighted_) {
        if (weight > 0) chosen = rule;
        if ((left -= weight) < 0) break;
    }
    return chosen;
}

std::span<const double> Rewriter::arguments(const Rule& rule) {
    if (!rule.arguments) return {};
    const auto values = rule.arguments.values();
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::isfinite(values[i])) continue;
        for (const Module& module : grammar_.productions[rule.production].successor) {
            if (i < module.arguments.size()) {
                wrong(module.arguments[i], values[i], "a finite number");
                break;
            }
            i -= module.arguments.size();
        }
        return {};
    }
    return values;
}

}  // namespace sinew::lsystem
