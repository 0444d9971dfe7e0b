/// @file module_reader.h
/// Symbols, modules and patterns of a .lsys file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sinew/grow/cursor.h"
#include "sinew/grow/grammar.h"

namespace sinew::lsystem {

/// Each function reads from the cursor, and returns false where the cursor has noted an error.
class ModuleReader {
  public:
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

    std::vector<std::string> long_names_;  ///< longest first
};

}  // namespace sinew::lsystem
