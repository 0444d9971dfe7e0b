/// @file parse.h
/// Text to Grammar by recursive descent; what the grammar means is checked by compile() (program.h).
#pragma once

#include <string>
#include <string_view>

#include "sinew/base/result.h"
#include "sinew/grow/grammar.h"

namespace sinew::lsystem {

/// The statements of a `.lsys` file. Fails with the place and what was expected there. Formulas are kept as
/// text, the values in the result are defaults.
Result<Grammar> parse_statements(std::string_view text, std::string name);

}  // namespace sinew::lsystem
