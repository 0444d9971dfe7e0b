#include "sinew/sqm/skin.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <memory>

#include "cli/commands.h"
#include "cli/files.h"
#include "sinew/io/units.h"
#include "sinew/subdivide/subdivide.h"

namespace sinew::cli {
namespace {

constexpr const char* skin_examples = R"(Examples:
  sinew skin hand.sinew -o hand.obj                  the control mesh
  sinew skin hand.sinew -o hand.glb --subdivide 2    smooth: twice subdivided
  sinew skin neurons/*.swc -o meshes/ --to ply       a folder of measured skeletons
  cat hand.sinew | sinew skin - --from sinew -o - --to obj > hand.obj

Radii: with --fit control the mesh itself has the radii of the skeleton, with --fit limit (the default with
--subdivide) the smooth surface has that subdivision makes of it.
Measured skeletons (.swc, .graph) are thinned out where nodes are far closer than a radius; --keep-nodes keeps all.)";

struct SkinCommand {
    FileOptions files;
    std::string sides = "auto";
    int levels = 0;
    std::string fit;
    std::string stage = "place";
    bool keep_nodes = false;

    SkinOptions options(bool measured) const;
    Result<Outcome> work(Session& session, const Job& job) const;
};

const std::map<std::string, SkinStage> stages{{"polyhedra", SkinStage::polyhedra},
                                              {"refine", SkinStage::refine},
                                              {"bridge", SkinStage::bridge},
                                              {"place", SkinStage::place}};

SkinOptions SkinCommand::options(bool measured) const {
    const bool limit = fit.empty() ? levels > 0 : fit == "limit";
    return {.sides = sides == "auto" ? 0 : std::stoi(sides),
            .fit = limit ? Fit::limit : Fit::control,
            .repair = measured && !keep_nodes,
            .stage = stages.at(stage)};
}

Outcome describe(const Skin& skin, const Job& job, double seconds) {
    Outcome outcome;
    outcome.text = fmt::format("{}: {}, {} component{}, {} cycle{}, {:.2f} s\n", job.output,
                               counts_text(skin.mesh), skin.components, skin.components == 1 ? "" : "s",
                               skin.cycles, skin.cycles == 1 ? "" : "s", seconds);
    outcome.json = counts_json(skin.mesh);
    outcome.json["components"] = skin.components;
    outcome.json["cycles"] = skin.cycles;
    outcome.json["euler"] = 2 * skin.components - 2 * skin.cycles;
    outcome.json["irregular_at_most"] = skin.irregular;
    outcome.json["seconds"] = std::round(1e6 * seconds) / 1e6;
    return outcome;
}

Result<Outcome> SkinCommand::work(Session& session, const Job& job) const {
    if (const auto able = check_mesh_output(job, files); !able) return fail(able.error());
    const auto read = read_input_skeleton(session, job, files);
    if (!read) return fail(read.error());

    const auto begin = std::chrono::steady_clock::now();
    const SkinOptions chosen = options(read->measured);
    auto made = skin(read->document, chosen, session.progress(0, levels > 0 ? 0.5 : 0.9));
    if (!made) return fail(made.error());
    if (const auto told = session.warn(job.input, made->warnings); !told) return fail(told.error());
    if (levels > 0) {
        // Whoever wants the radii on the limit surface wants the vertices there too.
        const SubdivideOptions finer{.levels = levels, .limit = chosen.fit == Fit::limit};
        auto fine = subdivide(made->mesh, finer, session.progress(0.5, 0.9));
        if (!fine) return fail(fine.error());
        made->mesh = std::move(*fine);
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;

    const double metres = metres_in(read->document.unit).value_or(1);
    const auto written = write_output_mesh(made->mesh, job, files, {.metres_a_unit = metres});
    if (!written) return fail(written.error());
    return describe(*made, job, seconds.count());
}

std::string wrong_sides(const std::string& text) {
    const bool digits =
        !text.empty() && text.size() < 5 && text.find_first_not_of("0123456789") == std::string::npos;
    if (text == "auto" || (digits && std::stoi(text) >= 4 && std::stoi(text) <= 1024)) return {};
    return fmt::format("'{}' is neither auto nor a number from 4 to 1024", text);
}

}  // namespace

void add_skin(CLI::App& program, Session& session) {
    auto command = std::make_shared<SkinCommand>();
    CLI::App& app = *program.add_subcommand("skin", "Make a mesh of a skeleton");
    app.footer(skin_examples);
    add_inputs(app, command->files, "Skeletons");
    add_output(app, command->files, "The mesh");
    app.add_option("--subdivide", command->levels, "Subdivide the mesh so often")
        ->type_name("N")
        ->check(at_least(0, 10));
    app.add_option("--sides", command->sides,
                   "Vertices round every tube: auto (as few as will do) or a number")
        ->type_name("auto|N")
        ->check(CLI::Validator(wrong_sides, ""));
    app.add_option("--fit", command->fit, "Whose radii are those of the skeleton (see below)")
        ->type_name("control|limit")
        ->check(one_of({"control", "limit"}));
    app.add_flag("--keep-nodes", command->keep_nodes, "Thin out and merge no nodes of measured skeletons");
    app.add_option("--stage", command->stage,
                   "Write what this stage made: polyhedra, refine, bridge or place (all)")
        ->type_name("NAME")
        ->check(one_of({"polyhedra", "refine", "bridge", "place"}));
    add_strict(app, session);
    add_reporting(app, session);
    app.callback([command, &session] {
        session.run(command->files, ".obj", [&](const Job& job) { return command->work(session, job); });
    });
}

}  // namespace sinew::cli
