#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <sstream>

#include "cli/commands.h"
#include "cli/hints.h"
#include "cli/interrupt.h"

namespace sinew::cli {
namespace {

constexpr const char* about = R"(Sinew: skeleton in, clean quads out.)";
constexpr const char* footer = R"(Examples:
  sinew skin hand.sinew -o hand.obj
  sinew check hand.obj --skeleton hand.sinew
  sinew render hand.obj -o hand.png --wire
`sinew COMMAND --help` tells more of each.

Exit status: 0 done, 1 the input is bad, 2 the call is wrong, 3 the program is at fault or was stopped.)";

void declare(CLI::App& program, Session& session) {
    program.require_subcommand(1);
    program.set_version_flag("--version", "sinew " SINEW_VERSION, "Print the version and exit");
    program.set_help_flag("-h,--help", "Print this help and exit");
    program.get_formatter()->column_width(28);
    program.get_formatter()->label("REQUIRED", "(needed)");
    program.get_formatter()->label("SUBCOMMAND", "COMMAND");
    program.group("Commands");
    program.footer(footer);
    add_skin(program, session);
    add_check(program, session);
    add_convert(program, session);
    add_render(program, session);
    add_grow(program, session);
    add_subdivide(program, session);
    add_edit(program, session);
    add_formats(program, session);
}

const CLI::App& chosen_command(const CLI::App& program) {
    const auto chosen = program.get_subcommands();
    return chosen.empty() ? program : *chosen.front();
}

/// What the word that was not understood might have been.
std::string hint(const CLI::App& command, const std::string& word) {
    std::vector<std::string> choices;
    if (word.starts_with("-")) {
        for (const CLI::Option* option : command.get_options())
            for (const std::string& name : option->get_lnames()) choices.push_back("--" + name);
    } else {
        for (const CLI::App* each : command.get_subcommands([](const CLI::App*) { return true; }))
            choices.push_back(each->get_name());
    }
    const std::string near = nearest(word, choices);
    return near.empty() ? "" : fmt::format("; did you mean '{}'?", near);
}

struct Complaint {
    std::string text, advice;
};

Complaint describe(const CLI::App& program, const CLI::ParseError& error) {
    const CLI::App& command = chosen_command(program);
    const std::vector<std::string> unknown = program.remaining(true);
    std::string text = error.what();
    if (!unknown.empty()) {
        const std::string& word = unknown.front();
        const bool is_option = word.size() > 1 && word.starts_with("-");
        text = fmt::format("there is no {} '{}'",
                           is_option              ? "option"
                           : &command == &program ? "command"
                                                  : "argument",
                           word) +
               hint(command, word);
    } else if (&command == &program) {
        text = "a command is needed";
    }
    const std::string name = &command == &program ? "sinew" : "sinew " + command.get_name();
    return {text, fmt::format("Try '{} --help'.", name)};
}

/// Parses the command line and does what it says.
int run(int argc, char** argv) {
    Session session;
    CLI::App program(about, "sinew");
    declare(program, session);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& success) {  // --help, --version
        std::ostringstream text;
        program.exit(success, text, text);
        session.put(text.str());
        return session.status;
    } catch (const CLI::ParseError& error) {
        const Complaint complaint = describe(program, error);
        Terminal().error(complaint.text, complaint.advice);
        return exit_status(ErrorKind::call);
    }
    return session.status;
}

}  // namespace
}  // namespace sinew::cli

int main(int argc, char** argv) {
    sinew::cli::catch_interrupts();
    try {
        return sinew::cli::run(argc, argv);
    } catch (const std::bad_alloc&) {
        sinew::cli::Terminal().error("the memory does not suffice");
    } catch (const std::exception& error) {
        sinew::cli::Terminal().error(fmt::format("unexpected fault: {}; please report it", error.what()));
    }
    return sinew::cli::exit_status(sinew::ErrorKind::program);
}
