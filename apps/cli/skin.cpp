#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "cli/commands.h"
#include "cli/files.h"
#include "sinew/io/units.h"
#include "sinew/skeleton/validate.h"
#include "sinew/smooth/smooth_skin.h"

namespace sinew::cli {
namespace {

constexpr const char* skin_examples = R"(Examples:
  sinew skin hand.sinew -o hand.obj                  the control mesh
  sinew skin hand.sinew -o hand.glb --subdivide 2    smooth: twice subdivided
  sinew skin neurons/*.swc -o meshes/ --to ply       a folder of measured skeletons
  cat hand.sinew | sinew skin - --from sinew -o - --to obj > hand.obj

Radii: with --fit control the mesh itself has the radii of the skeleton, with --fit limit (the default with
--subdivide) the smooth surface has that subdivision makes of it, at once or later: sinew subdivide --limit.
Measured skeletons (.swc, .graph) are thinned out where nodes are far closer than a radius; --keep-nodes keeps all.)";

struct SkinCommand {
    FileOptions files;
    std::string sides = "auto";
    int levels = 0;
    std::string fit;
    std::string stage = "place";
    bool keep_nodes = false;
    std::optional<double> blend;
    Density density;

    SmoothSkinOptions options(bool measured) const;
    std::string advice(const Job& job) const;
    Result<Outcome> work(Session& session, const Job& job) const;
};

const std::map<std::string, SkinStage> stages{{"polyhedra", SkinStage::polyhedra},
                                              {"refine", SkinStage::refine},
                                              {"bridge", SkinStage::bridge},
                                              {"place", SkinStage::place}};

SmoothSkinOptions SkinCommand::options(bool measured) const {
    std::optional<Fit> fitted;
    if (!fit.empty()) fitted = fit == "limit" ? Fit::limit : Fit::control;
    return {.levels = levels,
            .fit = fitted,
            .sides = sides == "auto" ? 0 : std::stoi(sides),
            .repair = measured && !keep_nodes,
            .stage = stages.at(stage),
            .blend = blend,
            .density = density == Density{} ? std::nullopt : std::optional(density)};
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

/// A control mesh that is fitted to its limit stands out from the skeleton's radii, and so do the coarse levels
/// of what is made of it: mesh files do not say so.
std::string SkinCommand::advice(const Job& job) const {
    if (fit != "limit" || levels > 0 || stage != "place") return {};
    return fmt::format("  its limit surface has the radii: sinew subdivide {} --limit -o ...\n", job.output);
}

Result<Outcome> SkinCommand::work(Session& session, const Job& job) const {
    if (const auto able = check_mesh_output(job, files); !able) return fail(able.error());
    const auto read = read_input_skeleton(session, job, files);
    if (!read) return fail(read.error());

    const auto made = smooth_skin(read->document, options(read->measured), session.progress(0, 0.9));
    if (!made) return fail(made.error());
    const Skin& skin = made->skin;
    if (const auto told = session.warn(job.input, skin.warnings); !told) return fail(told.error());

    const double metres = metres_in(read->document.unit).value_or(1);
    const auto written = write_output_mesh(skin.mesh, job, files, {.metres_a_unit = metres});
    if (!written) return fail(written.error());
    Outcome outcome = describe(skin, job, made->skin_seconds + made->subdivide_seconds);
    outcome.text += advice(job);
    return outcome;
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
    CLI::App& app = add_command(program, command->files,
                                {.name = "skin",
                                 .about = "Make a mesh of a skeleton",
                                 .inputs = "Skeletons",
                                 .output = "The mesh",
                                 .examples = skin_examples});
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
    app.add_option("--blend", command->blend,
                   "How soft crotches are: radius of the ball that rolls round joints, in radii (0.25)")
        ->type_name("B")
        ->check(CLI::Range(0.0, largest_blend).description(""));
    app.add_option("--aspect", command->density.aspect,
                   "No quad of a tube is longer than so many times its width")
        ->type_name("A")
        ->check(CLI::Range(least_aspect, 1e6).description(""));
    app.add_option("--edge-length", command->density.edge_length, "No quad of a tube is longer than this")
        ->type_name("L")
        ->check(CLI::PositiveNumber.description(""));
    app.add_flag("--keep-nodes", command->keep_nodes, "Thin out and merge no nodes of measured skeletons");
    app.add_option("--stage", command->stage,
                   "Write what this stage made: polyhedra, refine, bridge or place (all)")
        ->type_name("NAME")
        ->check(one_of({"polyhedra", "refine", "bridge", "place"}));
    add_strict(app, session);
    work_on_each_input(app, session, command, ".obj");
}

}  // namespace sinew::cli
