/// @file files.h
/// Reading and writing for the commands, with warnings told and Ctrl-C heeded; and the options that name
/// files.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "cli/interrupt.h"
#include "cli/session.h"
#include "sinew/io/files.h"
#include "sinew/io/mesh_formats.h"
#include "sinew/io/skeleton_formats.h"
#include "sinew/mesh/quad_mesh.h"

namespace sinew::cli {

/// What the help of a command says first.
struct CommandWords {
    std::string name, about;
    std::string inputs, output;  ///< what these are; no output: the command writes no file
    std::string examples;
};

/// A subcommand with the options that name its files.
CLI::App& add_command(CLI::App& program, FileOptions& files, const CommandWords& words);

// Options: IN... with --from; -o with --to; --json and --quiet; --strict.
void add_inputs(CLI::App& command, FileOptions& files, const std::string& what);
void add_output(CLI::App& command, FileOptions& files, const std::string& what);
void add_reporting(CLI::App& command, Session& session);
void add_strict(CLI::App& command, Session& session);

/// Ends a command: --json and --quiet, and what is done with each input, `command->work(session, job)`.
/// @param command    has FileOptions `files`; lives as long as the program's options
/// @param extension  see plan_jobs()
template <class Command>
void work_on_each_input(CLI::App& app, Session& session, std::shared_ptr<Command> command,
                        std::string_view extension) {
    add_reporting(app, session);
    app.callback([command = std::move(command), &session, extension] {
        session.run(command->files, extension, [&](const Job& job) { return command->work(session, job); });
    });
}

/// A check for numbers: `least` or more, at most a billion (or `most`).
CLI::Validator at_least(std::int64_t least, std::int64_t most = 1'000'000'000);

/// A check for words: one of the choices.
CLI::Validator one_of(std::vector<std::string> choices);

/// What may be broken off at any time: reading, and all else before there is anything to clean up.
template <class Work>
auto interruptibly(const Work& work) {
    const InterruptsEndProgram meanwhile;
    return work();
}

/// Writing may be broken off where it waits for somebody else, such as the reader of a pipe.
template <class Write>
auto unless_waiting(const std::string& path, const Write& write) {
    std::optional<InterruptsEndProgram> meanwhile;
    if (writes_directly(path)) meanwhile.emplace();
    return write();
}

/// "1 node", "2 nodes".
std::string counted(std::size_t count, std::string_view one, std::string_view more);

/// Fails (kind cancelled) once Ctrl-C was pressed: look before anything is written.
Result<void> heed_interrupt();

/// Is the input read as a mesh? Formats that hold both, such as glTF, are where the file has a mesh; standard
/// input, which can be read only once, is wherever its format can hold one. Fails for a format that holds
/// neither.
Result<bool> is_mesh(const Job& job, const FileOptions& files);

/// @param validate  false: a native document that validate() refuses is read all the same
Result<ReadSkeleton> read_input_skeleton(Session& session, const Job& job, const FileOptions& files,
                                         bool validate = true);
Result<QuadMesh> read_input_mesh(const Job& job, const FileOptions& files);
Result<std::string> read_input_text(const Job& job);

/// Fails if a mesh cannot be written where the job wants it, before any work is done.
Result<void> check_mesh_output(const Job& job, const FileOptions& files);
/// @param options  its format is that of the job
Result<void> write_output_mesh(const QuadMesh& mesh, const Job& job, const FileOptions& files,
                               MeshWriteOptions options = {});
Result<void> write_output_skeleton(Session& session, const Document& document, const Job& job,
                                   const FileOptions& files);

/// {"vertices", "faces", "quads", "triangles"} of a mesh, and the same as text: "1,234 vertices, 1,230
/// quads".
Json counts_json(const QuadMesh& mesh);
std::string counts_text(const QuadMesh& mesh);

}  // namespace sinew::cli
