#include "live/pipeline.h"

#include <chrono>

namespace sinew::modeler {
LiveMesh Pipeline::run(const Document& document, const MeshOptions& options, const Progress& progress,
                       bool with_buffers) {
    LiveMesh result;
    result.options = options;
    // The control mesh has the radii anyway where it is what one sees.
    const auto fit = options.to_limit ? std::nullopt : std::optional(Fit::control);
    auto made = skinner_(
        document, {.levels = options.level, .fit = fit, .sides = options.sides, .repair = options.repair},
        progress);
    if (!made) {
        result.error = made.error();
        return result;
    }
    Skin& skinned = made->skin;
    result.skin_ms = 1000 * made->skin_seconds;
    result.subdivide_ms = 1000 * made->subdivide_seconds;
    result.warnings = std::move(skinned.warnings);
    result.components = skinned.components;
    result.cycles = skinned.cycles;
    result.irregular_at_most = skinned.irregular;
    result.mesh = std::make_shared<const QuadMesh>(std::move(skinned.mesh));
    if (with_buffers) {
        const auto begin = std::chrono::steady_clock::now();
        result.buffers = std::make_shared<const MeshBuffers>(mesh_buffers(*result.mesh));
        result.buffers_ms =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    }
    return result;
}

void measure(LiveMesh& mesh) {
    const Topology topology = build_topology(*mesh.mesh);
    mesh.validation = validate(*mesh.mesh, topology);
    mesh.measures = measure(*mesh.mesh, topology);
}

}  // namespace sinew::modeler
