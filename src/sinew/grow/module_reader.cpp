#include "sinew/grow/module_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "sinew/grow/formula.h"
#include "sinew/grow/turtle_symbols.h"

namespace sinew::lsystem {
namespace {

constexpr std::string_view a_module = "a letter, a digit, a turtle symbol or an @word";

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)); }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)); }

std::string all_words() {
    std::string words;
    for (const TurtleSymbol& known : turtle_symbols())
        if (known.symbol[0] == '@') words.append(words.empty() ? "" : ", ").append(known.symbol);
    return words;
}

bool at_arrow(const Cursor& cursor) {
    return cursor.rest().starts_with("->") || cursor.rest().starts_with("-->");
}

}  // namespace

void ModuleReader::declare(const std::string& name) {
    std::size_t at = 0;
    for (const char c : name) {
        const auto [entry, added] = letters_[at].next.try_emplace(c, letters_.size());
        at = entry->second;
        if (added) letters_.emplace_back();
    }
    letters_[at].ends_name = true;
}

bool ModuleReader::patterns(Cursor& cursor, std::vector<Pattern>& list) const {
    if (cursor.accept("*")) return true;  // as in the book: no context
    int depth = 0;
    while (!cursor.at_end() && !at_arrow(cursor) &&
           std::string_view("<>:").find(cursor.peek()) == std::string_view::npos) {
        Pattern pattern;
        if (!symbol(cursor, pattern.symbol) || !parameters(cursor, pattern)) return false;
        depth += pattern.symbol.text == "[" ? 1 : pattern.symbol.text == "]" ? -1 : 0;
        if (depth < 0) return cursor.wrong(pattern.symbol.offset, "this ']' has no '[' before it");
        list.push_back(std::move(pattern));
    }
    if (depth > 0) return cursor.expected("']'");
    return !list.empty() || cursor.expected(a_module);
}

bool ModuleReader::parameters(Cursor& cursor, Pattern& pattern) {
    if (!cursor.accept("(")) return true;
    do {
        const Text name = cursor.name();
        if (name.empty()) return cursor.expected("the name of a parameter");
        if (is_function(name.text))
            return cursor.wrong(name.offset, fmt::format("'{}' already has a meaning in formulas", name.text),
                                "take another name");
        if (pattern.parameters.size() == most_parameters)
            return cursor.wrong(name.offset,
                                fmt::format("more than {} parameters of one module", most_parameters));
        pattern.parameters.push_back(name.text);
    } while (cursor.accept(","));
    return cursor.accept(")") || cursor.expected("',' or ')' after a parameter");
}

bool ModuleReader::modules(Cursor& cursor, std::vector<Module>& list) const {
    std::vector<std::size_t> open;
    while (!cursor.at_end()) {
        Module module;
        if (!symbol(cursor, module.symbol) || !arguments(cursor, module)) return false;
        if (module.symbol.text == "[") open.push_back(module.symbol.offset);
        if (module.symbol.text == "]") {
            if (open.empty()) return cursor.wrong(module.symbol.offset, "this ']' has no '[' before it");
            open.pop_back();
        }
        list.push_back(std::move(module));
    }
    return open.empty() ||
           cursor.wrong(open.back(), "expected a ']' for this '[' before the end of the line");
}

bool ModuleReader::arguments(Cursor& cursor, Module& module) {
    if (!cursor.accept("(")) return true;
    do {
        module.arguments.push_back(cursor.formula(",)"));
        if (module.arguments.back().empty()) return cursor.expected("a formula");
    } while (cursor.accept(","));
    return cursor.accept(")") ||
           cursor.expected(fmt::format("')' after the arguments of {}", module.symbol.text));
}

bool ModuleReader::symbol(Cursor& cursor, Text& symbol) const {
    const std::string_view rest = cursor.rest();
    const std::size_t length = symbol_length(rest);
    if (length == 0 && rest.starts_with('>'))
        return cursor.expected(a_module, "every production starts in the first column of a line of its own");
    if (length == 0) return cursor.expected(a_module);
    if (rest[0] == '@' && !find_turtle_symbol(rest.substr(0, length)))
        return cursor.wrong(cursor.offset(), fmt::format("unknown word '{}'", rest.substr(0, length)),
                            "there are " + all_words());
    symbol = {std::string(rest.substr(0, length)), cursor.offset()};
    cursor.advance(length);
    return true;
}

/// Of the symbol that a text begins with; 0 for none. An @ begins a word, known or not.
std::size_t ModuleReader::symbol_length(std::string_view text) const {
    if (text.empty()) return 0;
    if (text[0] == '@')
        return static_cast<std::size_t>(std::find_if_not(text.begin() + 1, text.end(), is_letter) -
                                        text.begin());
    std::size_t longest = 0;
    for (std::size_t at = 0, length = 0; length < text.size();) {
        const auto next = letters_[at].next.find(text[length]);
        if (next == letters_[at].next.end()) break;
        at = next->second;
        ++length;
        if (letters_[at].ends_name) longest = length;
    }
    if (longest > 0) return longest;
    return is_letter(text[0]) || is_digit(text[0]) || find_turtle_symbol(text.substr(0, 1)) ? 1 : 0;
}

}  // namespace sinew::lsystem
