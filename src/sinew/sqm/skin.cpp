#include "sinew/sqm/skin.h"

#include "sinew/extend/extend.h"
#include "sinew/skeleton/condition.h"
#include "sinew/sqm/bridge.h"
#include "sinew/sqm/network.h"
#include "sinew/sqm/place.h"
#include "sinew/sqm/polyhedra.h"
#include "sinew/sqm/refine.h"
#include "sinew/sqm/symmetry.h"

namespace sinew {
namespace {

std::int64_t irregular_at_most(const sqm::Network& network, const sqm::Polyhedra& polyhedra,
                               const sqm::Bridge& bridge) {
    std::int64_t sum =
        static_cast<std::int64_t>(bridge.mesh.features.poles.size()) + 8 * std::ssize(network.lone);
    for (std::int32_t j = 0; j < network.joint_count(); ++j)
        sum += 2 * (polyhedra.cell_first[j + 1] - polyhedra.cell_first[j] - 2);
    return sum;
}

}  // namespace

Result<Skin> skin(const Document& document, const SkinOptions& options, const Progress& progress) {
    Skin result;
    progress(0.0, "condition");
    CleanGraph graph = condition(document, {.repair = options.repair});
    result.warnings = graph.warnings;
    const GraphCounts counts = count_graph(static_cast<std::int32_t>(graph.position.size()), graph.bones);
    result.components = counts.components;
    result.cycles = counts.cycles;

    const Result<Plain> plain = extend(document, std::move(graph));
    if (!plain) return fail(plain.error());
    const sqm::Network network = sqm::find_network(*plain);

    progress(0.1, "polyhedra");
    const auto polyhedra = sqm::make_polyhedra(*plain, network, progress);
    if (!polyhedra) return fail(polyhedra.error());
    sqm::Images images = sqm::find_images(*plain, network, *polyhedra);

    progress(0.3, "refine");
    auto refinement = sqm::refine(network, *polyhedra, images, {.sides = options.sides}, progress);
    if (!refinement && images.any() && !progress.cancelled()) {
        images = {};  // a closed mesh matters more than a symmetric one
        refinement = sqm::refine(network, *polyhedra, images, {.sides = options.sides}, progress);
    }
    if (!refinement) return fail(refinement.error());

    progress(0.5, "bridge");
    const sqm::JointPoints points = sqm::make_joint_points(*plain, network, *polyhedra, *refinement);
    const sqm::Stations stations = sqm::make_stations(*plain, network, *polyhedra, *refinement, points);
    const sqm::Parts parts{*plain, network, *polyhedra, *refinement, points, stations};
    auto bridge = sqm::bridge(parts, progress);
    if (!bridge) return fail(bridge.error());

    progress(0.8, "place");
    sqm::place(parts, images, *bridge);
    result.irregular = irregular_at_most(network, *polyhedra, *bridge);
    result.mesh = std::move(bridge->mesh);
    progress(1.0, "done");
    return result;
}

}  // namespace sinew
