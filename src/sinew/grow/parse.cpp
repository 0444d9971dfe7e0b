#include "sinew/grow/parse.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <map>
#include <utility>

#include "sinew/grow/cursor.h"
#include "sinew/grow/formula.h"
#include "sinew/grow/module_reader.h"

namespace sinew::lsystem {
namespace {

/// Settings that are formulas, with how many.
constexpr std::array<std::pair<std::string_view, std::size_t>, 7> formula_settings{
    {{"steps", 1}, {"seed", 1}, {"angle", 1}, {"length", 1}, {"radius", 1}, {"thinning", 1}, {"tropism", 4}}};
constexpr std::string_view all_settings =
    "%axiom, %steps, %seed, %angle, %length, %radius, %thinning, %tropism, %ignore, %modules, %unit, "
    "%symmetry, %finally";

bool accept_arrow(Cursor& cursor) { return cursor.accept("->") || cursor.accept("-->"); }

class GrammarReader {
  public:
    GrammarReader(std::string_view text, std::string name) {
        grammar_.source = Source(text, std::move(name));
    }

    Result<Grammar> read();

  private:
    bool statement(Cursor& cursor);
    bool setting(Cursor& cursor);
    bool formulas(Cursor& cursor, Text word, std::size_t count);
    bool ignore(Cursor& cursor);
    bool declare_modules(Cursor& cursor);
    bool symmetry(Cursor& cursor);
    bool constant(Cursor& cursor);
    bool production(Cursor& cursor);
    bool condition(Cursor& cursor, Text& condition);

    bool is_constant(const Cursor& cursor) const;
    bool once(Cursor& cursor, const Text& word);

    Grammar grammar_;
    ModuleReader reader_;
    std::map<std::string, std::size_t> constant_of_;  ///< index in Grammar::constants
    bool finally_ = false;
};

Result<Grammar> GrammarReader::read() {
    const Source& source = grammar_.source;
    for (std::size_t line = 0; line < source.line_count();) {
        const std::size_t begin = line++;
        const std::string_view first = source.line(begin);
        if (first.find_first_not_of(' ') == std::string_view::npos) continue;
        // Indented lines, and empty ones between them, go on with the statement above.
        std::size_t end = source.start_of(begin) + first.find_last_not_of(' ') + 1;
        for (; line < source.line_count(); ++line) {
            const std::string_view next = source.line(line);
            if (!next.empty() && next[0] != ' ') break;
            if (next.find_first_not_of(' ') != std::string_view::npos)
                end = source.start_of(line) + next.find_last_not_of(' ') + 1;
        }
        Cursor cursor(source, source.start_of(begin), end);
        if (!statement(cursor)) return tl::unexpected(*cursor.error());
    }
    const bool has_axiom = std::any_of(grammar_.settings.begin(), grammar_.settings.end(),
                                       [](const Setting& s) { return s.word.text == "axiom"; });
    if (!has_axiom)
        return source.error(source.text().size(), "expected an axiom before the end of the file",
                            "add a line such as %axiom F");
    return std::move(grammar_);
}

bool GrammarReader::statement(Cursor& cursor) {
    // A % before a word is a setting; the turtle's % stands in successors only.
    if (cursor.peek() == '%') return setting(cursor);
    return is_constant(cursor) ? constant(cursor) : production(cursor);
}

bool GrammarReader::once(Cursor& cursor, const Text& word) {
    for (const Setting& other : grammar_.settings)
        if (other.word.text == word.text)
            return cursor.wrong(word.offset, fmt::format("%{} is already set in line {}", word.text,
                                                         grammar_.source.line_of(other.word.offset) + 1));
    grammar_.settings.push_back({word, {}});
    return true;
}

bool GrammarReader::setting(Cursor& cursor) {
    cursor.advance(1);
    const Text word = cursor.name();
    if (word.empty()) return cursor.expected("the name of a setting after '%'", std::string(all_settings));
    if (!once(cursor, word)) return false;
    if (word.text == "axiom") return reader_.modules(cursor, grammar_.axiom);
    if (word.text == "ignore") return ignore(cursor);
    if (word.text == "modules") return declare_modules(cursor);
    if (word.text == "symmetry") return symmetry(cursor);
    if (word.text == "unit") {
        const Text unit = cursor.name();
        grammar_.unit = unit.text;
        return !unit.empty() && cursor.at_end() ? true : cursor.expected("one word such as m or mm");
    }
    if (word.text == "finally") {
        finally_ = true;
        return cursor.at_end() ||
               cursor.expected("nothing after %finally", "productions follow on lines of their own");
    }
    for (const auto& [name, count] : formula_settings)
        if (word.text == name) return formulas(cursor, word, count);
    return cursor.wrong(word.offset, fmt::format("unknown setting '%{}'", word.text),
                        fmt::format("there are {}", all_settings));
}

bool GrammarReader::formulas(Cursor& cursor, Text word, std::size_t count) {
    auto& list = grammar_.settings.back().formulas;
    for (;;) {
        if (cursor.at_end()) return cursor.expected("a formula");
        list.push_back(cursor.formula(","));
        if (list.back().empty()) return cursor.expected("a formula");
        if (cursor.at_end()) break;
        if (list.size() == count)
            return cursor.wrong(cursor.offset(), fmt::format("%{} takes {} formula{}", word.text, count,
                                                             count > 1 ? "s" : ""));
        cursor.accept(",");
    }
    return list.size() == count ||
           cursor.expected(fmt::format("',' and {} formulas in all after %{}", count, word.text));
}

bool GrammarReader::ignore(Cursor& cursor) {
    while (!cursor.at_end()) {
        Text name;
        if (!reader_.symbol(cursor, name)) return false;
        grammar_.ignored.push_back(std::move(name.text));
        cursor.accept(",");
    }
    return true;
}

bool GrammarReader::declare_modules(Cursor& cursor) {
    if (!grammar_.axiom.empty() || !grammar_.productions.empty())
        return cursor.wrong(cursor.offset(), "%modules must stand before the axiom and the productions",
                            "their letters have been taken apart already");
    do {
        const Text name = cursor.name();
        if (name.text.size() < 2) return cursor.expected("a name of two or more letters");
        if (name.text.size() > ModuleReader::longest_name)
            return cursor.wrong(
                name.offset, fmt::format("this name is longer than {} letters", ModuleReader::longest_name));
        reader_.declare(name.text);
        cursor.accept(",");
    } while (!cursor.at_end());
    return true;
}

bool GrammarReader::symmetry(Cursor& cursor) {
    Symmetry& result = grammar_.symmetry;
    result.kind = cursor.peek() == 'm' ? Symmetry::Kind::mirror : Symmetry::Kind::radial;
    if (!cursor.accept("mirror") && !cursor.accept("radial"))
        return cursor.expected("'mirror x' or 'radial z 8'");
    const std::size_t axis = std::string_view("xyz").find(cursor.peek());
    if (axis == std::string_view::npos) return cursor.expected("one of the axes x, y, z");
    result.axis = static_cast<int>(axis);
    cursor.advance(1);
    if (result.kind == Symmetry::Kind::radial) {
        const std::string_view rest = cursor.rest();
        const auto [end, code] = std::from_chars(rest.data(), rest.data() + rest.size(), result.count);
        if (code != std::errc{} || result.count < 2 || result.count > 1000)
            return cursor.expected("how many copies there are, 2 to 1000");
        cursor.advance(static_cast<std::size_t>(end - rest.data()));
    }
    return cursor.at_end() || cursor.expected("the end of the line");
}

bool GrammarReader::is_constant(const Cursor& cursor) const {
    Cursor ahead = cursor;
    return !ahead.name().empty() && ahead.peek() == '=' && ahead.peek(1) != '=';
}

bool GrammarReader::constant(Cursor& cursor) {
    GrowConstant result;
    const Text name = cursor.name();
    const auto [earlier, is_new] = constant_of_.emplace(name.text, grammar_.constants.size());
    if (!is_new)
        return cursor.wrong(
            name.offset,
            fmt::format("'{}' already has a value, in line {}", name.text,
                        grammar_.source.line_of(grammar_.constants[earlier->second].formula.offset) + 1));
    if (is_function(name.text) || name.text == "pi")
        return cursor.wrong(name.offset, fmt::format("'{}' already has a meaning in formulas", name.text),
                            "take another name");
    cursor.accept("=");
    if (cursor.at_end()) return cursor.expected("a formula");
    result.name = name.text;
    result.formula = cursor.formula("");
    result.remark = grammar_.source.remark(grammar_.source.line_of(name.offset));
    grammar_.constants.push_back(std::move(result));
    return true;
}

bool GrammarReader::production(Cursor& cursor) {
    Production result;
    result.finally = finally_;
    std::vector<Pattern> middle;
    const std::size_t begin = cursor.offset();
    if (!reader_.patterns(cursor, middle)) return false;
    if (cursor.accept("<")) {
        result.left = std::exchange(middle, {});
        if (!reader_.patterns(cursor, middle)) return false;
    }
    if (middle.size() != 1 || middle[0].symbol.text == "[" || middle[0].symbol.text == "]")
        return cursor.wrong(middle.empty() ? begin : middle[0].symbol.offset,
                            "expected one module that is replaced, neither a bracket nor several",
                            "a production is written A -> F A, a constant a = 1");
    result.predecessor = std::move(middle[0]);
    if (cursor.accept(">") && !reader_.patterns(cursor, result.right)) return false;
    if (cursor.accept(":") && !condition(cursor, result.condition)) return false;
    if (!accept_arrow(cursor)) return cursor.expected("'->'");
    if (cursor.accept("(")) {
        result.weight = cursor.formula(")");
        if (result.weight.empty()) return cursor.expected("a weight");
        if (!cursor.accept(")")) return cursor.expected("')' after the weight");
    }
    if (!reader_.modules(cursor, result.successor)) return false;
    for (const Pattern& pattern : result.left)
        if (pattern.symbol.text == "[" || pattern.symbol.text == "]")
            return cursor.wrong(pattern.symbol.offset,
                                "a left context has no brackets: it is the way to the root");
    grammar_.productions.push_back(std::move(result));
    return true;
}

bool GrammarReader::condition(Cursor& cursor, Text& condition) {
    const std::string_view rest = cursor.rest();
    std::size_t arrow = rest.find("->");
    if (arrow == std::string_view::npos) {
        cursor.until(cursor.offset() + rest.size());
        return cursor.expected("'->' after the condition");
    }
    if (arrow > 0 && rest[arrow - 1] == '-') --arrow;
    condition = cursor.until(cursor.offset() + arrow);
    if (condition.empty()) return cursor.expected("a condition");
    if (condition.text == "*") condition.text.clear();
    return true;
}

}  // namespace

Result<Grammar> parse_statements(std::string_view text, std::string name) {
    return GrammarReader(text, std::move(name)).read();
}

}  // namespace sinew::lsystem
