/// @file json.h
/// Results, errors and warnings as JSON, for --json.
#pragma once

#include <nlohmann/json.hpp>

#include "sinew/base/result.h"

namespace sinew::cli {

using Json = nlohmann::ordered_json;

/// {"kind", "message", "cure", "file", "line", "column", "path", "node"} without what is unknown.
Json to_json(const Error& error);
/// [{"message", "count", "nodes"}]
Json to_json(const Warnings& warnings);

/// One line of text; bytes that are no UTF-8 (in file names) become U+FFFD, and
/// nothing in it is obeyed by a terminal.
std::string line_of(const Json& value);

}  // namespace sinew::cli
