#include "sinew/grow/grow.h"

#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/files.h"
#include "sinew/io/files.h"

namespace sinew::cli {
namespace {

constexpr const char* grow_examples = R"(Examples:
  sinew grow tree.lsys -o tree.sinew
  sinew grow tree.lsys -o tree.sinew --steps 9 --seed 4 --set angle=25
  sinew grow tree.lsys -o - --to sinew | sinew skin - --from sinew -o tree.glb --subdivide 1

docs/lsystems.md explains the language.)";

struct GrowCommand {
    FileOptions files;
    GrowOptions options;
    std::vector<std::string> constants;  ///< NAME=VALUE

    Result<Outcome> work(Session& session, const Job& job) const;
};

Result<Outcome> GrowCommand::work(Session& session, const Job& job) const {
    if (const auto able = choose_format(job.output, files.to, FormatUse::write_skeleton); !able)
        return fail(able.error());
    const auto text = read_input_text(job);
    if (!text) return fail(text.error());
    const auto document = interruptibly([&]() -> Result<Document> {
        const auto grammar = parse_grammar(*text, input_name(job.input));
        if (!grammar) return fail(grammar.error());
        return grow(*grammar, options, session.progress());
    });
    if (!document) return fail(document.error());
    const auto written = write_output_skeleton(session, *document, job, files);
    if (!written) return fail(written.error());

    Outcome outcome;
    outcome.text = fmt::format("{}: {}\n", job.output, counted(document->nodes.size(), "node", "nodes"));
    outcome.json["nodes"] = document->nodes.size();
    return outcome;
}

using Constant = std::pair<std::string, double>;

/// "angle=25" -> angle, 25
std::optional<Constant> parse_constant(const std::string& text) {
    const std::size_t sign = text.find('=');
    double value = 0;
    if (sign == std::string::npos || sign == 0 || !CLI::detail::lexical_cast(text.substr(sign + 1), value))
        return std::nullopt;
    return Constant{text.substr(0, sign), value};
}

std::string wrong_constant(const std::string& text) {
    return parse_constant(text) ? "" : fmt::format("'{}' is not NAME=NUMBER", text);
}

}  // namespace

void add_grow(CLI::App& program, Session& session) {
    auto command = std::make_shared<GrowCommand>();
    CLI::App& app = *program.add_subcommand("grow", "Grow a skeleton from an L-system");
    app.footer(grow_examples);
    app.add_option("IN", command->files.inputs, "L-systems (.lsys); - is standard input")
        ->required()
        ->type_name("FILE");
    add_output(app, command->files, "The skeleton");
    app.add_option("--steps", command->options.steps, "Steps of derivation, instead of the file's")
        ->type_name("N")
        ->check(at_least(0));
    app.add_option("--seed", command->options.seed, "Seed of what is left to chance, instead of the file's")
        ->type_name("S");
    app.add_option("--set", command->constants, "Another value for a constant of the file")
        ->type_name("NAME=NUMBER")
        ->allow_extra_args(false)
        ->check(CLI::Validator(wrong_constant, ""));
    app.add_option("--limit", command->options.limit, "Most nodes that may grow (10000000)")
        ->type_name("N")
        ->check(at_least(1));
    add_reporting(app, session);
    app.callback([command, &session] {
        for (const std::string& text : command->constants)
            command->options.constants.push_back(*parse_constant(text));
        session.run(command->files, ".sinew", [&](const Job& job) { return command->work(session, job); });
    });
}

}  // namespace sinew::cli
