/// @file json_text.h
/// JSON text to values, with errors that name a place. For the sources of this folder only.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "sinew/base/result.h"

namespace sinew {

/// Keys stay in the order of the file.
using Json = nlohmann::ordered_json;

/// How deep arrays and objects may stand in one another.
inline constexpr std::size_t deepest_json = 100;

/// Parses UTF-8 text (a byte order mark at its start is skipped). Fails, with line and column or with the
/// JSON pointer, for what is no JSON, a number too large for double precision, a key twice in one object, and
/// too deep nesting.
Result<Json> parse_json(std::string_view text);

/// The line, from 1, at which the value that `pointer` names starts, or else the innermost that exists on the
/// way to it. Reads the text once more: meant for errors.
std::int64_t line_of(std::string_view text, std::string_view pointer);

/// One step of a JSON pointer: "a/b" is written "a~1b".
std::string pointer_step(std::string_view key);

/// The value of an object's key; null where there is none.
const Json* find(const Json& object, std::string_view key);

/// An object's keys but for these.
Json without(const Json& object, std::initializer_list<std::string_view> keys);

/// The integer that a value is, also where it is written as 1.0. Empty for anything else, and beyond 64 bits
/// (as 1.0: 53).
std::optional<std::int64_t> integer_in(const Json& value);

}  // namespace sinew
