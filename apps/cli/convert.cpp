#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/files.h"

namespace sinew::cli {
namespace {

constexpr const char* convert_examples = R"(Examples:
  sinew convert neuron.swc -o neuron.sinew       skeleton to skeleton
  sinew convert hand.obj -o hand.glb             mesh to mesh
  sinew convert rigs/*.glb -o bones/ --to graph  the joints of many files

A mesh of a skeleton is made by `sinew skin`. What a format cannot carry is told as a warning; `sinew formats` lists
what each can.)";

struct ConvertCommand {
    FileOptions files;
    bool ascii = false;

    Result<Outcome> skeleton(Session& session, const Job& job) const;
    Result<Outcome> mesh(const Job& job) const;
    Result<Outcome> work(Session& session, const Job& job) const;
};

/// Who asks for a mesh of a skeleton is told how to get one.
Result<void> check_skeleton_output(const Job& job, const FileOptions& files) {
    const auto format = choose_format(job.output, files.to, FormatUse::write_skeleton);
    if (format) return {};
    Error error = format.error();
    if (choose_format(job.output, files.to, FormatUse::write_mesh)) {
        error.message = fmt::format("{} is a skeleton, and the output holds meshes only", job.input);
        error.cure = fmt::format("make a mesh of it: sinew skin {} -o {}", job.input, job.output);
        error.file.clear();
    }
    return fail(error);
}

Result<Outcome> ConvertCommand::skeleton(Session& session, const Job& job) const {
    if (const auto able = check_skeleton_output(job, files); !able) return fail(able.error());
    const auto read = read_input_skeleton(session, job, files);
    if (!read) return fail(read.error());
    const auto written = write_output_skeleton(session, read->document, job, files);
    if (!written) return fail(written.error());

    Outcome outcome;
    outcome.text = fmt::format("{}: {}\n", job.output, counted(read->document.nodes.size(), "node", "nodes"));
    outcome.json["nodes"] = read->document.nodes.size();
    return outcome;
}

Result<Outcome> ConvertCommand::mesh(const Job& job) const {
    if (const auto able = check_mesh_output(job, files); !able) return fail(able.error());
    const auto read = read_input_mesh(job, files);
    if (!read) return fail(read.error());
    if (const auto written = write_output_mesh(*read, job, files, {.ascii = ascii}); !written)
        return fail(written.error());
    return Outcome{.text = fmt::format("{}: {}\n", job.output, counts_text(*read)),
                   .json = counts_json(*read)};
}

/// A file may hold a mesh and the joints that move it: the output says which is meant.
bool skeleton_to_skeleton(const Job& job, const FileOptions& files) {
    return choose_format(job.input, files.from, FormatUse::read_skeleton) &&
           choose_format(job.output, files.to, FormatUse::write_skeleton);
}

Result<Outcome> ConvertCommand::work(Session& session, const Job& job) const {
    if (skeleton_to_skeleton(job, files)) return skeleton(session, job);
    const auto kind = is_mesh(job, files);
    if (!kind) return fail(kind.error());
    return *kind ? mesh(job) : skeleton(session, job);
}

}  // namespace

void add_convert(CLI::App& program, Session& session) {
    auto command = std::make_shared<ConvertCommand>();
    CLI::App& app = add_command(program, command->files,
                                {.name = "convert",
                                 .about = "Write a skeleton or a mesh in another format",
                                 .inputs = "Skeletons or meshes",
                                 .output = "The same in another format",
                                 .examples = convert_examples});
    app.add_flag("--ascii", command->ascii, "PLY as text");
    add_strict(app, session);
    work_on_each_input(app, session, command, "");
}

}  // namespace sinew::cli
