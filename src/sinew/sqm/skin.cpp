#include "sinew/sqm/skin.h"

#include "sinew/extend/extend.h"
#include "sinew/skeleton/condition.h"
#include "sinew/skeleton/symmetry.h"
#include "sinew/skeleton/validate.h"
#include "sinew/sqm/bridge/bridge.h"
#include "sinew/sqm/bridge/features.h"
#include "sinew/sqm/cells/images.h"
#include "sinew/sqm/cells/polyhedra.h"
#include "sinew/sqm/counts/refine.h"
#include "sinew/sqm/fit/fit.h"
#include "sinew/sqm/name_drawn.h"
#include "sinew/sqm/network.h"
#include "sinew/sqm/outward.h"
#include "sinew/sqm/place/place.h"
#include "sinew/sqm/place/symmetrise.h"
#include "sinew/sqm/points/joint_points.h"
#include "sinew/sqm/rings/stations.h"
#include "sinew/sqm/stage_mesh.h"
#include "sinew/sqm/surface/find_surfaces.h"

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

/// The stages of sqm, in their order.
Result<QuadMesh> make_mesh(const Plain& skeleton, const SkinOptions& options, const Density& density,
                           const Progress& progress, Skin& result) {
    using namespace sqm;
    const Network network = find_network(skeleton);

    progress(0.1, "polyhedra");
    const auto polyhedra = make_polyhedra(skeleton, network, progress);
    if (!polyhedra) return fail(polyhedra.error());
    if (options.stage == SkinStage::polyhedra) return polyhedra_mesh(skeleton, network, *polyhedra);

    progress(0.3, "refine");
    const JointSurfaces surfaces = find_surfaces(skeleton, network);
    Images images = find_images(skeleton, network, *polyhedra);
    auto refinement =
        refine(skeleton, network, *polyhedra, surfaces, images, {.sides = options.sides}, progress);
    if (!refinement && images.any() && !progress.cancelled()) {
        images = {};  // a closed mesh matters more than a symmetric one
        refinement =
            refine(skeleton, network, *polyhedra, surfaces, images, {.sides = options.sides}, progress);
    }
    if (!refinement) return fail(refinement.error());
    const JointPoints points = make_joint_points(skeleton, network, *polyhedra, *refinement, surfaces);
    if (options.stage == SkinStage::refine)
        return refined_mesh(skeleton, network, *polyhedra, *refinement, points);

    progress(0.5, "bridge");
    const Stations stations = make_stations(
        skeleton, network, *polyhedra, *refinement, surfaces, points,
        {.support = options.fit == Fit::limit, .aspect = density.aspect, .edge_length = density.edge_length});
    const Parts parts{skeleton, network, *polyhedra, *refinement, surfaces, points, stations};
    auto bridged = bridge(parts, progress);
    if (!bridged) return fail(bridged.error());
    result.irregular = irregular_at_most(network, *polyhedra, *bridged);

    progress(0.8, "place");
    const bool ideal = options.stage != SkinStage::bridge;
    place(parts, {.ideal = ideal}, *bridged);
    add_features(parts, *bridged);
    // Which vertices are images of which is told by their places, before the fit moves them.
    const auto image = vertex_images(parts, images, *bridged);
    if (options.fit == Fit::limit && ideal)
        if (const auto fitted = fit_limit(parts, *bridged); !fitted) return fail(fitted.error());
    make_symmetric(images, image, bridged->mesh.positions);
    turn_outward(parts, *bridged);
    return std::move(bridged->mesh);
}

}  // namespace

Result<Skin> skin(const Document& document, const SkinOptions& options, const Progress& progress) {
    if (const auto valid = validate(document); !valid) return fail(valid.error());
    Skin result;
    progress(0.0, "condition");
    const bool symmetric = document.symmetry.kind != Symmetry::Kind::none;
    const ExpandedSymmetry expanded = symmetric ? expand_symmetry(document) : ExpandedSymmetry{};
    const Document& whole = symmetric ? expanded.document : document;
    const CleanGraph graph = condition(whole, {.repair = options.repair});
    result.warnings = graph.warnings;
    const GraphCounts counts = count_graph(static_cast<std::int32_t>(graph.position.size()), graph.bones);
    result.components = counts.components;
    result.cycles = counts.cycles;

    Plain plain = extend(whole, graph, result.warnings);
    plain.symmetry = symmetric ? carry_symmetry(plain, expanded.generator, expanded.order, expanded.image)
                               : find_mirror(plain);
    plain.blend.reserve(plain.source_node.size());
    for (const std::int32_t node : plain.source_node)
        plain.blend.push_back(std::clamp(
            whole.nodes[node].blend.value_or(options.blend.value_or(document.blend.value_or(default_blend))),
            0.0, largest_blend));
    const Density density = options.density.value_or(document.density);
    auto mesh = make_mesh(plain, options, density, progress, result);
    if (!mesh) return fail(mesh.error());
    result.mesh = std::move(*mesh);
    if (symmetric) sqm::name_drawn(document, expanded, result.mesh);
    progress(1.0, "done");
    return result;
}

}  // namespace sinew
