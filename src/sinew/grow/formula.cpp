#include "sinew/grow/formula.h"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "sinew/base/portable_math.h"

namespace sinew::lsystem {
namespace {

double modulo(double a, double b) { return a - b * std::floor(a / b); }
double tangent(double degrees) { return portable::sine(degrees) / portable::cosine(degrees); }
double sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }
double negation(double x) { return x == 0 ? 1 : 0; }
double smaller(double a, double b) { return b < a ? b : a; }
double larger(double a, double b) { return b > a ? b : a; }
double draw_uniform(void* random, double low, double high) {
    return static_cast<Random*>(random)->uniform(low, high);
}
double draw_normal(void* random, double mean, double deviation) {
    return static_cast<Random*>(random)->normal(mean, deviation);
}

using Unary = double (*)(double);
using Binary = double (*)(double, double);
constexpr std::array<std::pair<const char*, Unary>, 10> unary_functions{
    {{"sin", portable::sine},
     {"cos", portable::cosine},
     {"tan", tangent},
     {"sqrt", [](double x) { return std::sqrt(x); }},
     {"exp", portable::exponential},
     {"log", portable::logarithm},
     {"abs", [](double x) { return std::fabs(x); }},
     {"sign", sign},
     {"floor", [](double x) { return std::floor(x); }},
     {"ceil", [](double x) { return std::ceil(x); }}}};
constexpr std::array<std::pair<const char*, Binary>, 4> binary_functions{
    {{"atan2", portable::arc_tangent}, {"mod", modulo}, {"min", smaller}, {"max", larger}}};
constexpr std::array random_functions{"random", "normal"};

/// muParser does not let its own ^ be replaced, so formulas reach it with this in place of ^.
constexpr char power_sign = '~';

constexpr std::size_t longest_formula = 19'999;  ///< muParser takes no longer ones

std::unique_ptr<mu::Parser> make_functions(Random& random) {
    auto parser = std::make_unique<mu::Parser>();
    parser->ClearFun();
    parser->ClearConst();
    for (const auto& [name, function] : unary_functions) parser->DefineFun(name, function);
    for (const auto& [name, function] : binary_functions) parser->DefineFun(name, function);
    parser->DefineFun("round", Unary([](double x) { return std::round(x); }));
    parser->DefineFunUserData("random", draw_uniform, &random, false);
    parser->DefineFunUserData("normal", draw_normal, &random, false);
    parser->DefineInfixOprt("!", negation);
    parser->DefineOprt(std::string(1, power_sign), portable::power, mu::prPOW, mu::oaRIGHT, true);
    return parser;
}

bool starts_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

std::size_t end_of_name(std::string_view text, std::size_t at) {
    while (at < text.size() && in_name(text[at])) ++at;
    return at;
}

std::size_t end_of_number(std::string_view text, std::size_t at) {
    const auto digits = [&] {
        while (at < text.size() && std::isdigit(static_cast<unsigned char>(text[at]))) ++at;
    };
    digits();
    if (at < text.size() && text[at] == '.') ++at, digits();
    if (at >= text.size() || (text[at] != 'e' && text[at] != 'E')) return at;
    const std::size_t mantissa = at++;
    if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
    const std::size_t exponent = at;
    digits();
    return at > exponent ? at : mantissa;
}

/// What is wrong with the character at `at`, or nothing.
std::string wrong_character(std::string_view text, std::size_t at) {
    const char c = text[at], next = at + 1 < text.size() ? text[at + 1] : ' ';
    const char before = at > 0 ? text[at - 1] : ' ';
    const bool half_of_pair = next == c || before == c;
    if (c == '=' && !half_of_pair && std::string_view("<>!").find(before) == std::string_view::npos)
        return "expected '==', found '='";
    if (c == '&' && !half_of_pair) return "expected '&&', found '&'";
    if (c == '|' && !half_of_pair) return "expected '||', found '|'";
    if (std::string_view("+-*/^()<>=!&|?:, ").find(c) == std::string_view::npos)
        return fmt::format("{} cannot stand in a formula", found_at(text, at));
    return {};
}

/// muParser's complaint in the words of the other messages.
std::string translated(const mu::ParserError& error, std::string_view text, std::size_t at) {
    const std::string found = found_at(text, at);
    const bool number =
        at < text.size() && (std::isdigit(static_cast<unsigned char>(text[at])) || text[at] == '.');
    if (number && error.GetCode() == mu::ecUNASSIGNABLE_TOKEN)
        return "expected a number that a double can hold";
    switch (error.GetCode()) {
        case mu::ecUNEXPECTED_OPERATOR:
            return fmt::format("expected a value, found {}", found);
        case mu::ecUNEXPECTED_PARENS:
            if (text[at] == ')') return "expected a value, found ')'";
            [[fallthrough]];
        case mu::ecUNASSIGNABLE_TOKEN:
        case mu::ecUNEXPECTED_VAL:
        case mu::ecUNEXPECTED_VAR:
        case mu::ecUNEXPECTED_FUN:
            return fmt::format("expected an operator, found {}", found);
        case mu::ecMISSING_PARENS:
            return fmt::format("expected ')', found {}", found);
        case mu::ecTOO_MANY_PARAMS:
            return fmt::format("too many arguments for {}", error.GetToken());
        case mu::ecTOO_FEW_PARAMS:
            return fmt::format("too few arguments for {}", error.GetToken());
        case mu::ecMISSING_ELSE_CLAUSE:
            return fmt::format("expected ':' of the '?' before, found {}", found);
        case mu::ecMISPLACED_COLON:
            return "this ':' has no '?' before it";
        case mu::ecUNEXPECTED_ARG:
        case mu::ecUNEXPECTED_ARG_SEP:
            return "a ',' cannot stand here";
        default:
            return fmt::format("expected a value, found {}", found);
    }
}

}  // namespace

bool is_function(std::string_view name) {
    const auto has = [&](const auto& entry) { return name == entry.first; };
    return std::any_of(unary_functions.begin(), unary_functions.end(), has) ||
           std::any_of(binary_functions.begin(), binary_functions.end(), has) || name == "round" ||
           std::find(random_functions.begin(), random_functions.end(), name) != random_functions.end();
}

std::vector<std::string> names_in(const Text& formula) {
    std::vector<std::string> names;
    const std::string& text = formula.text;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = end_of_name(text, at);
        if (starts_name(text[at])) names.push_back(text.substr(at, end - at));
        at = std::max(end, at + 1);
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

Formula::Formula() = default;
Formula::Formula(Formula&&) noexcept = default;
Formula& Formula::operator=(Formula&&) noexcept = default;
Formula::~Formula() = default;

std::span<const double> Formula::values() const {
    int count = 0;
    if (parsers_.size() == 1) return {parsers_[0]->Eval(count), count_};
    values_.clear();
    for (const auto& parser : parsers_) {
        const double* first = parser->Eval(count);
        values_.insert(values_.end(), first, first + count);
    }
    return values_;
}

FormulaCompiler::FormulaCompiler(const Source& source, Random& random)
    : source_(source), functions_(make_functions(random)) {
    constants_["pi"] = 3.141592653589793;
}
FormulaCompiler::~FormulaCompiler() = default;

Result<void> FormulaCompiler::check_names(const Text& formula, std::span<const Variable> variables) const {
    const std::string& text = formula.text;
    if (text.find_first_not_of(' ') == std::string::npos)
        return source_.error(formula.offset, "expected a formula, found nothing");
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t place = formula.offset + at;
        if (starts_name(text[at])) {
            const std::size_t end = end_of_name(text, at);
            const std::string name = text.substr(at, end - at);
            const bool variable = std::any_of(variables.begin(), variables.end(),
                                              [&](const Variable& v) { return v.name == name; });
            if (!variable && !constants_.contains(name) && !is_function(name)) {
                std::string known;
                for (const Variable& v : variables) known += (known.empty() ? "" : ", ") + v.name;
                for (const auto& [constant, value] : constants_)
                    known += (known.empty() ? "" : ", ") + constant;
                return source_.error(place, fmt::format("unknown name '{}'", name), "known here: " + known);
            }
            const std::size_t next = text.find_first_not_of(' ', end);
            if (is_function(name) && !variable && (next == std::string::npos || text[next] != '('))
                return source_.error(place, fmt::format("expected '(' after the function {}", name));
            at = end;
        } else if (std::isdigit(static_cast<unsigned char>(text[at])) || text[at] == '.') {
            at = end_of_number(text, at);
        } else {
            if (std::string wrong = wrong_character(text, at); !wrong.empty())
                return source_.error(place, std::move(wrong));
            ++at;
        }
    }
    return {};
}

Result<std::unique_ptr<mu::Parser>> FormulaCompiler::parse(const std::string& text,
                                                           std::span<const Variable> variables,
                                                           const Text& place, std::size_t expected) const {
    try {
        auto parser = std::make_unique<mu::Parser>(*functions_);
        for (const Variable& variable : variables)
            parser->DefineVar(variable.name, const_cast<double*>(variable.value));
        for (const std::string& name : names_in(Text{text, 0}))
            if (const auto constant = constants_.find(name);
                constant != constants_.end() && !parser->GetVar().contains(name))
                parser->DefineConst(name, constant->second);
        std::string spelled = text;
        std::replace(spelled.begin(), spelled.end(), '^', power_sign);
        parser->SetExpr(spelled);
        int count = 0;
        parser->Eval(count);
        if (count != static_cast<int>(expected))
            return source_.error(place.offset, "a ',' cannot stand here");
        return parser;
    } catch (const mu::ParserError& error) {
        const bool at_end = error.GetPos() < 0 || static_cast<std::size_t>(error.GetPos()) > text.size();
        std::size_t at = at_end ? text.size() : static_cast<std::size_t>(error.GetPos());
        return source_.error(place.offset + at, translated(error, text, at));
    } catch (const std::exception& error) {
        return source_.error(place.offset, fmt::format("this formula cannot be read ({})", error.what()));
    }
}

Result<Formula> FormulaCompiler::compile(std::span<const Text> formulas,
                                         std::span<const Variable> variables) const {
    Formula result;
    result.count_ = formulas.size();
    for (std::size_t first = 0; first < formulas.size();) {
        std::string all;
        std::size_t end = first;
        for (; end < formulas.size() && all.size() + formulas[end].text.size() < longest_formula; ++end) {
            if (auto checked = check_names(formulas[end], variables); !checked)
                return tl::unexpected(checked.error());
            all += (all.empty() ? "" : ",") + formulas[end].text;
        }
        if (end == first)
            return source_.error(formulas[first].offset,
                                 fmt::format("this formula is longer than {} characters", longest_formula));
        auto parser = parse(all, variables, formulas[first], end - first);
        if (!parser) {  // find out whose fault it is
            for (const Text& formula : formulas.subspan(first, end - first))
                if (auto one = parse(formula.text, variables, formula, 1); !one)
                    return tl::unexpected(one.error());
            return tl::unexpected(parser.error());
        }
        result.parsers_.push_back(std::move(*parser));
        first = end;
    }
    return result;
}

}  // namespace sinew::lsystem
