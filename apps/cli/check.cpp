#include "sinew/mesh/check.h"

#include <memory>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/mesh_report.h"
#include "cli/skeleton_report.h"

namespace sinew::cli {
namespace {

constexpr const char* check_examples = R"(Examples:
  sinew check hand.obj
  sinew check hand.obj --skeleton hand.sinew      beside it: irregular vertices, distance from the round cones
  sinew check neuron.swc                          what is wrong with a skeleton, what skinning would repair
  sinew check meshes/*.ply --json                 one JSON object a file

Exit status 1: a mesh that is not closed, manifold, oriented outwards and finite, or a skeleton that cannot be
skinned. With --strict also a mesh that has faces of no area or runs through itself, and a skeleton that would be
repaired.)";

struct CheckCommand {
    FileOptions files;
    std::string skeleton;
    bool fast = false;

    Result<Outcome> mesh(Session& session, const Job& job) const;
    Result<Outcome> work(Session& session, const Job& job) const;
};

Result<Outcome> CheckCommand::mesh(Session& session, const Job& job) const {
    std::optional<SkeletonFacts> facts;
    if (!skeleton.empty()) {
        const auto read = interruptibly([&] { return read_skeleton(skeleton); });
        if (!read) return fail(read.error());
        facts = facts_of(*read);
    }
    const auto read = read_input_mesh(job, files);
    if (!read) return fail(read.error());
    const RoundCones* cones = facts && facts->cones.size() > 0 ? &facts->cones : nullptr;
    const auto report = check(*read, {.self_intersections = !fast, .cones = cones}, session.progress());
    if (!report) return fail(report.error());

    Outcome outcome{.text = mesh_text(job.input, *report, facts), .json = mesh_json(*report, facts)};
    outcome.good = session.strict ? report->clean() : report->validation.solid();
    return outcome;
}

Result<Outcome> CheckCommand::work(Session& session, const Job& job) const {
    const auto kind = is_mesh(job, files);
    if (!kind) return fail(kind.error());
    if (*kind) return mesh(session, job);
    if (!skeleton.empty())
        return fail(ErrorKind::call, "--skeleton goes with a mesh",
                    "leave it out to check a skeleton by itself");
    return check_skeleton(session, job, files);
}

}  // namespace

void add_check(CLI::App& program, Session& session) {
    auto command = std::make_shared<CheckCommand>();
    CLI::App& app = add_command(program, command->files,
                                {.name = "check",
                                 .about = "Tell whether a mesh or a skeleton is sound",
                                 .inputs = "Meshes or skeletons",
                                 .examples = check_examples});
    app.add_option("--skeleton", command->skeleton, "The skeleton that the mesh was made of")
        ->type_name("FILE");
    app.add_flag("--fast", command->fast, "Do not look for faces that run through each other");
    add_strict(app, session);
    work_on_each_input(app, session, command, "");
}

}  // namespace sinew::cli
