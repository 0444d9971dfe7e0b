#include "cli/files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "sinew/io/files.h"

namespace sinew::cli {
namespace {

struct FaceCounts {
    std::int64_t quads = 0, triangles = 0, others = 0;
};

FaceCounts count_faces(const QuadMesh& mesh) {
    FaceCounts counts;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::size_t size = mesh.face(f).size();
        ++(size == 4 ? counts.quads : size == 3 ? counts.triangles : counts.others);
    }
    return counts;
}

}  // namespace

std::string counted(std::size_t count, std::string_view one, std::string_view more) {
    return fmt::format("{} {}", count, count == 1 ? one : more);
}

Result<void> heed_interrupt() {
    if (interrupted()) return Progress::stopped();
    return {};
}

CLI::App& add_command(CLI::App& program, FileOptions& files, const CommandWords& words) {
    CLI::App& app = *program.add_subcommand(words.name, words.about);
    app.footer(words.examples);
    add_inputs(app, files, words.inputs);
    if (!words.output.empty()) add_output(app, files, words.output);
    return app;
}

void add_inputs(CLI::App& command, FileOptions& files, const std::string& what) {
    command.add_option("IN", files.inputs, what + "; - is standard input")->required()->type_name("FILE");
    command.add_option("--from", files.from, "Format of the input, where its extension does not say")
        ->type_name("FORMAT");
}

void add_output(CLI::App& command, FileOptions& files, const std::string& what) {
    command
        .add_option("-o,--output", files.output, what + "; - is standard output; a folder for several inputs")
        ->required()
        ->type_name("FILE");
    command.add_option("--to", files.to, "Format of the output, where its extension does not say")
        ->type_name("FORMAT");
}

void add_reporting(CLI::App& command, Session& session) {
    command.add_flag("--json", session.json, "Print the result as JSON, one object a line and input");
    command.add_flag("-q,--quiet", session.quiet, "No summary, no warnings, no progress");
}

void add_strict(CLI::App& command, Session& session) {
    command.add_flag("--strict", session.strict, "Refuse what would be repaired with a warning");
}

CLI::Validator at_least(std::int64_t least, std::int64_t most) {
    const std::string wanted = fmt::format("a whole number from {} to {}", least, most);
    return CLI::Validator(
        [=](const std::string& text) {
            std::int64_t value = 0;
            const bool good = CLI::detail::lexical_cast(text, value) && value >= least && value <= most;
            return good ? std::string() : fmt::format("'{}' is not {}", text, wanted);
        },
        "");
}

CLI::Validator one_of(std::vector<std::string> choices) {
    const std::string list = fmt::format("{}", fmt::join(choices, ", "));
    return CLI::Validator(
        [choices = std::move(choices), list](const std::string& text) {
            const bool good = std::find(choices.begin(), choices.end(), text) != choices.end();
            return good ? std::string() : fmt::format("'{}' is none of {}", text, list);
        },
        "");
}

Result<bool> is_mesh(const Job& job, const FileOptions& files) {
    const bool skeleton = choose_format(job.input, files.from, FormatUse::read_skeleton).has_value();
    const auto mesh = choose_format(job.input, files.from, FormatUse::read_mesh);
    if (!skeleton && !mesh) return fail(mesh.error());
    if (skeleton && mesh && job.input != "-")
        return interruptibly([&] { return holds_mesh(job.input, files.from); });
    return mesh.has_value();
}

Result<ReadSkeleton> read_input_skeleton(Session& session, const Job& job, const FileOptions& files,
                                         bool validate) {
    const ReadOptions options{.format = files.from, .strict = session.strict, .validate = validate};
    auto read = interruptibly([&] { return read_skeleton(job.input, options); });
    if (!read) return read;
    if (const auto told = session.warn(job.input, read->warnings); !told) return fail(told.error());
    return read;
}

Result<QuadMesh> read_input_mesh(const Job& job, const FileOptions& files) {
    return interruptibly([&] { return read_mesh(job.input, files.from); });
}

Result<std::string> read_input_text(const Job& job) {
    return interruptibly([&] { return read_file(job.input); });
}

Result<void> check_mesh_output(const Job& job, const FileOptions& files) {
    const auto format = choose_format(job.output, files.to, FormatUse::write_mesh);
    if (!format) return fail(format.error());
    return {};
}

Result<void> write_output_mesh(const QuadMesh& mesh, const Job& job, const FileOptions& files,
                               MeshWriteOptions options) {
    if (auto on = heed_interrupt(); !on) return on;
    options.format = files.to;
    return unless_waiting(job.output, [&] { return write_mesh(mesh, job.output, options); });
}

Result<void> write_output_skeleton(Session& session, const Document& document, const Job& job,
                                   const FileOptions& files) {
    if (auto on = heed_interrupt(); !on) return on;
    const auto written =
        unless_waiting(job.output, [&] { return write_skeleton(document, job.output, files.to); });
    if (!written) return fail(written.error());
    return session.warn(job.output == "-" ? job.input : job.output, *written);
}

Json counts_json(const QuadMesh& mesh) {
    const FaceCounts counts = count_faces(mesh);
    Json json{{"vertices", mesh.vertex_count()},
              {"faces", mesh.face_count()},
              {"quads", counts.quads},
              {"triangles", counts.triangles}};
    if (counts.others > 0) json["other_faces"] = counts.others;
    return json;
}

std::string counts_text(const QuadMesh& mesh) {
    const FaceCounts counts = count_faces(mesh);
    const auto size = [](std::int64_t count) { return static_cast<std::size_t>(count); };
    std::string text = counted(mesh.vertex_count(), "vertex", "vertices") + ", " +
                       counted(size(counts.quads), "quad", "quads");
    if (counts.triangles > 0) text += ", " + counted(size(counts.triangles), "triangle", "triangles");
    if (counts.others > 0) text += ", " + counted(size(counts.others), "larger face", "larger faces");
    return text;
}

}  // namespace sinew::cli
