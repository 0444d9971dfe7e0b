#include "live/pipeline.h"

#include <chrono>

#include "sinew/skeleton/validate.h"
#include "sinew/sqm/skin.h"

namespace sinew::modeler {
namespace {

class Watch {
  public:
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const double ms = std::chrono::duration<double, std::milli>(now - last_).count();
        last_ = now;
        return ms;
    }

  private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

struct Pipeline::Memory {};

Pipeline::Pipeline() : memory_(std::make_unique<Memory>()) {}
Pipeline::~Pipeline() = default;

LiveMesh Pipeline::run(const Document& document, const MeshOptions& options, const Progress& progress,
                       bool with_buffers) {
    LiveMesh result;
    Watch watch;
    if (auto sound = validate(document); !sound) {
        result.error = sound.error();
        return result;
    }
    const bool limit = options.to_limit && options.level > 0;
    auto skinned = skin(document,
                        {.sides = options.sides,
                         .fit = limit ? Fit::limit : Fit::control,
                         .repair = options.repair},
                        progress);
    result.skin_ms = watch.lap();
    if (!skinned) {
        result.error = skinned.error();
        return result;
    }
    result.warnings = std::move(skinned->warnings);
    result.components = skinned->components;
    result.cycles = skinned->cycles;
    result.irregular_at_most = skinned->irregular;
    result.mesh = std::make_shared<const QuadMesh>(std::move(skinned->mesh));
    if (with_buffers) result.buffers = std::make_shared<const MeshBuffers>(mesh_buffers(*result.mesh));
    result.buffers_ms = watch.lap();
    return result;
}

void measure(LiveMesh& mesh) {
    const Topology topology = make_topology(*mesh.mesh);
    mesh.validation = validate(*mesh.mesh, topology);
    mesh.measures = measure(*mesh.mesh, topology);
}

}  // namespace sinew::modeler
