/// @file module_reader.h
/// Symbols, modules and patterns of a .lsys file.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sinew/grow/cursor.h"
#include "sinew/grow/grammar.h"

namespace sinew::lsystem {

/// Each function reads from the cursor, and returns false where the cursor has noted an error.
class ModuleReader {
  public:
    /// Most letters of a declared name, and most parameters of a module that is replaced or looked at.
    static constexpr std::size_t longest_name = 100, most_parameters = 100;

    /// From now on these letters together are one symbol.
    void declare(const std::string& name);

    bool symbol(Cursor& cursor, Text& symbol) const;
    /// Modules up to the end of the statement; brackets come in pairs.
    bool modules(Cursor& cursor, std::vector<Module>& list) const;
    /// Patterns up to an arrow or one of < > :, or the book's * for none.
    bool patterns(Cursor& cursor, std::vector<Pattern>& list) const;

  private:
    std::size_t symbol_length(std::string_view text) const;
    static bool parameters(Cursor& cursor, Pattern& pattern);
    static bool arguments(Cursor& cursor, Module& module);

    /// The declared names letter by letter: to the node of a name's next letter. So that finding the longest one
    /// takes its length, however many there are.
    struct Letter {
        std::map<char, std::size_t> next;
        bool ends_name = false;
    };
    std::vector<Letter> letters_{1};
};

}  // namespace sinew::lsystem
