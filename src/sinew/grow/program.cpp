#include "sinew/grow/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace sinew::lsystem {
namespace {

class Compiler {
  public:
    Compiler(const Grammar& grammar, const GrowOptions& options)
        : grammar_(grammar), options_(options), formulas_(grammar.source, *program_.random) {}

    Result<Program> run();

  private:
    Result<void> overrides() const;
    Result<void> seed();
    Result<void> constants();
    Result<void> settings();
    Result<void> setting(const Setting& setting, std::span<const double> values);
    Result<void> production(std::size_t index);
    Result<void> axiom();
    Result<std::vector<double>> values(std::span<const Text> formulas, std::uint64_t key);
    Result<SymbolId> symbol(const Text& name, std::size_t arity);
    Result<std::vector<Text>> successor(const std::vector<Module>& modules, std::vector<SymbolId>& symbols);
    Result<void> context(const std::vector<Pattern>& patterns, std::vector<ContextModule>& result,
                         Rule& rule);
    Result<std::vector<Variable>> variables(const Production& production, const Rule& rule) const;
    void sort_rules();

    const Grammar& grammar_;
    const GrowOptions& options_;
    Program program_;
    FormulaCompiler formulas_;
    std::set<std::string> ignored_{grammar_.ignored.begin(), grammar_.ignored.end()};
    std::map<std::pair<std::string, std::int32_t>, SymbolId> symbols_;
};

bool draws(const Text& formula) {
    const auto names = names_in(formula);
    return std::any_of(names.begin(), names.end(),
                       [](const auto& name) { return name == "random" || name == "normal"; });
}

std::size_t parameter_count(const std::vector<Pattern>& patterns) {
    std::size_t count = 0;
    for (const Pattern& pattern : patterns) count += pattern.parameters.size();
    return count;
}

Result<void> Compiler::overrides() const {
    for (const auto& [name, value] : options_.constants) {
        const auto same = [&name = name](const GrowConstant& constant) { return constant.name == name; };
        if (std::none_of(grammar_.constants.begin(), grammar_.constants.end(), same)) {
            std::string known;
            for (const GrowConstant& constant : grammar_.constants)
                known += (known.empty() ? "" : ", ") + constant.name;
            return fail(Error{.kind = ErrorKind::call,
                              .message = fmt::format("there is no constant '{}'", name),
                              .cure = known.empty() ? "the file has no constants" : "there are " + known,
                              .file = grammar_.source.name()});
        }
        if (!std::isfinite(value))
            return fail(ErrorKind::call, fmt::format("the constant '{}' cannot be {}", name, value),
                        "give a finite number");
    }
    return {};
}

/// Values of formulas that only know constants, each finite.
Result<std::vector<double>> Compiler::values(std::span<const Text> formulas, std::uint64_t key) {
    if (formulas.empty()) return std::vector<double>{};
    auto compiled = formulas_.compile(formulas, {});
    if (!compiled) return tl::unexpected(compiled.error());
    *program_.random = Random(key);
    const auto result = compiled->values();
    for (std::size_t i = 0; i < formulas.size(); ++i)
        if (!std::isfinite(result[i]))
            return grammar_.source.error(formulas[i].offset, fmt::format("this formula gives {}", result[i]),
                                         "expected a finite number");
    return std::vector<double>(result.begin(), result.end());
}

// The seed is known before the constants, since these may draw.
Result<void> Compiler::seed() {
    program_.seed = options_.seed.value_or(1);
    for (const Setting& setting : grammar_.settings) {
        if (setting.word.text != "seed") continue;
        auto value = values(setting.formulas, 0);
        if (!value) return tl::unexpected(value.error());
        if ((*value)[0] < 0 || (*value)[0] > 0x1p53 || (*value)[0] != std::floor((*value)[0]))
            return grammar_.source.error(setting.formulas[0].offset,
                                         "expected a whole number from 0 to 2^53");
        if (!options_.seed) program_.seed = static_cast<std::uint64_t>((*value)[0]);
    }
    return {};
}

Result<void> Compiler::constants() {
    const std::uint64_t key = child_key(mix(program_.seed), 0);
    for (std::size_t i = 0; i < grammar_.constants.size(); ++i) {
        const GrowConstant& constant = grammar_.constants[i];
        auto value = values(std::span(&constant.formula, 1), child_key(key, i));
        if (!value) return tl::unexpected(value.error());
        for (const auto& [name, instead] : options_.constants)
            if (name == constant.name) (*value)[0] = instead;
        program_.constants.push_back((*value)[0]);
        formulas_.define(constant.name, (*value)[0]);
    }
    return {};
}

Result<void> Compiler::settings() {
    const std::uint64_t key = child_key(mix(program_.seed), 1);
    for (std::size_t i = 0; i < grammar_.settings.size(); ++i) {
        const Setting& one = grammar_.settings[i];
        if (one.formulas.empty() || one.word.text == "seed") continue;
        auto result = values(one.formulas, child_key(key, i));
        if (!result) return tl::unexpected(result.error());
        if (auto done = setting(one, *result); !done) return done;
    }
    if (options_.steps) program_.steps = *options_.steps;
    if (program_.steps < 0)
        return fail(ErrorKind::call, fmt::format("{} steps cannot be grown", program_.steps),
                    "give 0 or more");
    return {};
}

Result<void> Compiler::setting(const Setting& setting, std::span<const double> values) {
    const std::string& word = setting.word.text;
    const std::size_t place = setting.formulas[0].offset;
    TurtleDefaults& turtle = program_.turtle;
    if (word == "steps") {
        if (values[0] < 0 || values[0] > 1e9 || values[0] != std::floor(values[0]))
            return grammar_.source.error(place, "expected a whole number from 0 to 1000000000");
        program_.steps = static_cast<int>(values[0]);
    }
    if (word == "angle") turtle.angle = values[0];
    if (word == "length") turtle.length = values[0];
    if (word == "radius") turtle.radius = values[0];
    if (word == "thinning") turtle.thinning = values[0];
    if ((word == "radius" || word == "thinning") && !(values[0] > 0))
        return grammar_.source.error(place, fmt::format("expected a number above 0 for %{}", word));
    if (word == "tropism") turtle.tropism = Vec3(values[0], values[1], values[2]), turtle.bending = values[3];
    return {};
}

Result<SymbolId> Compiler::symbol(const Text& name, std::size_t arity) {
    const auto count = static_cast<std::int32_t>(arity);
    const auto [entry, added] =
        symbols_.try_emplace({name.text, count}, static_cast<SymbolId>(program_.symbols.size()));
    if (!added) return entry->second;
    Symbol result{.name = name.text, .arity = count};
    if (const TurtleSymbol* turtle = find_turtle_symbol(name.text)) {
        const bool strict =
            name.text.size() > 1 || turtle->command == Command::push || turtle->command == Command::pop;
        if (strict && count != turtle->least && count != turtle->most)
            return grammar_.source.error(
                name.offset, fmt::format("{} takes {} argument{}, found {}", name.text,
                                         turtle->least == turtle->most
                                             ? fmt::format("{}", turtle->least)
                                             : fmt::format("{} or {}", turtle->least, turtle->most),
                                         turtle->most == 1 ? "" : "s", count));
        result.command = turtle->command;
    }
    const bool bracket = result.command == Command::push || result.command == Command::pop;
    result.ignored = !bracket && ignored_.contains(name.text);
    result.parameters.resize(arity);
    program_.symbols.push_back(std::move(result));
    return entry->second;
}

/// Symbols of modules, and their arguments as one list.
Result<std::vector<Text>> Compiler::successor(const std::vector<Module>& modules,
                                              std::vector<SymbolId>& symbols) {
    std::vector<Text> arguments;
    for (const Module& module : modules) {
        auto id = symbol(module.symbol, module.arguments.size());
        if (!id) return tl::unexpected(id.error());
        symbols.push_back(*id);
        arguments.insert(arguments.end(), module.arguments.begin(), module.arguments.end());
    }
    return arguments;
}

Result<void> Compiler::context(const std::vector<Pattern>& patterns, std::vector<ContextModule>& result,
                               Rule& rule) {
    for (const Pattern& pattern : patterns) {
        auto id = symbol(pattern.symbol, pattern.parameters.size());
        if (!id) return tl::unexpected(id.error());
        result.push_back({*id, static_cast<std::int32_t>(rule.context_parameters.size())});
        rule.context_parameters.resize(rule.context_parameters.size() + pattern.parameters.size());
    }
    return {};
}

Result<std::vector<Variable>> Compiler::variables(const Production& production, const Rule& rule) const {
    std::vector<Variable> result;
    const Text* twice = nullptr;
    const auto add = [&](const Pattern& pattern, const double* values) {
        for (std::size_t i = 0; i < pattern.parameters.size(); ++i) {
            const std::string& name = pattern.parameters[i];
            if (std::any_of(result.begin(), result.end(), [&](const Variable& v) { return v.name == name; }))
                twice = &pattern.symbol;
            result.push_back({name, values + i});
        }
    };
    std::size_t slot = 0;
    for (const auto* patterns : {&production.left, &production.right})
        for (const Pattern& pattern : *patterns) {
            add(pattern, rule.context_parameters.data() + slot);
            slot += pattern.parameters.size();
        }
    const auto predecessor =
        symbols_.find({production.predecessor.symbol.text,
                       static_cast<std::int32_t>(production.predecessor.parameters.size())});
    add(production.predecessor, program_.symbols[predecessor->second].parameters.data());
    if (twice)
        return grammar_.source.error(twice->offset, "a parameter of this module has the name of another");
    return result;
}

Result<void> Compiler::production(std::size_t index) {
    const Production& source = grammar_.productions[index];
    Rule rule;
    rule.production = static_cast<std::int32_t>(index);
    rule.context_parameters.reserve(parameter_count(source.left) + parameter_count(source.right));
    const auto predecessor = symbol(source.predecessor.symbol, source.predecessor.parameters.size());
    if (!predecessor) return tl::unexpected(predecessor.error());
    if (auto left = context(source.left, rule.left, rule); !left) return left;
    if (auto right = context(source.right, rule.right, rule); !right) return right;
    const auto known = variables(source, rule);
    if (!known) return tl::unexpected(known.error());
    const auto texts = successor(source.successor, rule.successor);
    if (!texts) return tl::unexpected(texts.error());
    auto arguments = formulas_.compile(*texts, *known);
    if (!arguments) return tl::unexpected(arguments.error());
    rule.arguments = std::move(*arguments);
    for (auto [text, formula] :
         {std::pair{&source.condition, &rule.condition}, std::pair{&source.weight, &rule.weight}}) {
        if (text->empty()) continue;
        auto compiled = formulas_.compile(*text, *known);
        if (!compiled) return tl::unexpected(compiled.error());
        *formula = std::move(*compiled);
    }
    Symbol& replaced = program_.symbols[*predecessor];
    (source.finally ? replaced.finally : replaced.rules)
        .push_back(static_cast<std::int32_t>(program_.rules.size()));
    replaced.chance = replaced.chance || draws(source.condition) || !source.weight.empty();
    program_.chance = program_.chance || replaced.chance || std::any_of(texts->begin(), texts->end(), draws);
    program_.context = program_.context || rule.has_context();
    program_.rules.push_back(std::move(rule));
    return {};
}

Result<void> Compiler::axiom() {
    const auto texts = successor(grammar_.axiom, program_.axiom);
    if (!texts) return tl::unexpected(texts.error());
    auto arguments = values(*texts, child_key(mix(program_.seed), 2));
    if (!arguments) return tl::unexpected(arguments.error());
    program_.axiom_arguments = std::move(*arguments);
    return {};
}

// As in the book, a production with context goes before those without.
void Compiler::sort_rules() {
    const auto context = [&](std::int32_t rule) { return program_.rules[rule].has_context(); };
    for (Symbol& symbol : program_.symbols) {
        std::stable_partition(symbol.rules.begin(), symbol.rules.end(), context);
        std::stable_partition(symbol.finally.begin(), symbol.finally.end(), context);
    }
}

Result<Program> Compiler::run() {
    Result<void> done = overrides();
    if (done) done = seed();
    if (done) done = constants();
    if (done) done = settings();
    if (done) done = axiom();
    for (std::size_t i = 0; done && i < grammar_.productions.size(); ++i) done = production(i);
    if (!done) return tl::unexpected(done.error());
    sort_rules();
    return std::move(program_);
}

}  // namespace

Result<Program> compile(const Grammar& grammar, const GrowOptions& options) {
    return Compiler(grammar, options).run();
}

std::string to_text(const Symbol& symbol, const double* arguments) {
    std::string text = symbol.name;
    for (std::int32_t i = 0; i < symbol.arity; ++i)
        text += fmt::format("{}{:g}", i == 0 ? "(" : ", ", arguments[i]);
    return symbol.arity > 0 ? text + ")" : text;
}

}  // namespace sinew::lsystem
