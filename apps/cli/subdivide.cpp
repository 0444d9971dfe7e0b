#include "sinew/subdivide/subdivide.h"

#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/files.h"

namespace sinew::cli {
namespace {

constexpr const char* subdivide_examples = R"(Examples:
  sinew subdivide hand.obj -o smooth.obj --levels 2
  sinew subdivide hand.obj -o smooth.ply --levels 1 --limit    vertices on the surface that subdivision ends at
  sinew subdivide a.obj b.obj -o smooth/ --levels 3

Catmull-Clark; fans of triangles round a pole stay fans, without the crease that Catmull-Clark makes there
(--catmull-clark: with it). Creases, flat discs and circles of a skeleton are kept by `sinew skin --subdivide`, since
mesh files say nothing of them.)";

struct SubdivideCommand {
    FileOptions files;
    SubdivideOptions options;
    bool catmull_clark = false;

    Result<Outcome> work(Session& session, const Job& job) const;
};

Result<Outcome> SubdivideCommand::work(Session& session, const Job& job) const {
    if (const auto able = check_mesh_output(job, files); !able) return fail(able.error());
    const auto control = read_input_mesh(job, files);
    if (!control) return fail(control.error());
    SubdivideOptions chosen = options;
    chosen.detect_poles = !catmull_clark;
    const auto fine = subdivide(*control, chosen, session.progress());
    if (!fine) return fail(fine.error());
    if (const auto written = write_output_mesh(*fine, job, files); !written) return fail(written.error());
    return Outcome{.text = fmt::format("{}: {}\n", job.output, counts_text(*fine)),
                   .json = counts_json(*fine)};
}

}  // namespace

void add_subdivide(CLI::App& program, Session& session) {
    auto command = std::make_shared<SubdivideCommand>();
    CLI::App& app = add_command(program, command->files,
                                {.name = "subdivide",
                                 .about = "Make a mesh finer and smooth",
                                 .inputs = "Meshes",
                                 .output = "The finer mesh",
                                 .examples = subdivide_examples});
    app.add_option("--levels", command->options.levels, "Subdivide so often (1)")
        ->type_name("N")
        ->check(at_least(0, 20));
    app.add_flag("--limit", command->options.limit, "Put the vertices where endless subdivision would");
    app.add_flag("--catmull-clark", command->catmull_clark, "Treat poles as any other vertex");
    work_on_each_input(app, session, command, ".obj");
}

}  // namespace sinew::cli
