/// @file commands.h
/// The commands of the program. Each function declares one with its options; it runs once the line is parsed.
#pragma once

#include <CLI/CLI.hpp>

#include "cli/session.h"

namespace sinew::cli {

void add_skin(CLI::App& program, Session& session);
void add_check(CLI::App& program, Session& session);
void add_convert(CLI::App& program, Session& session);
void add_render(CLI::App& program, Session& session);
void add_grow(CLI::App& program, Session& session);
void add_subdivide(CLI::App& program, Session& session);
void add_edit(CLI::App& program, Session& session);
void add_formats(CLI::App& program, Session& session);

}  // namespace sinew::cli
