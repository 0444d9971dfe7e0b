#include "live/pipeline.h"

#include <algorithm>
#include <chrono>

#include "sinew/skeleton/validate.h"
#include "sinew/sqm/skin.h"
#include "sinew/subdivide/subdivide.h"

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

bool same_topology(const QuadMesh& a, const QuadMesh& b) {
    const Features &f = a.features, &g = b.features;
    const auto same_creases = [&] {
        return std::equal(
            f.creases.begin(), f.creases.end(), g.creases.begin(), g.creases.end(),
            [](const Crease& x, const Crease& y) { return x.edge == y.edge && x.sharpness == y.sharpness; });
    };
    return a.vertex_count() == b.vertex_count() && a.corners == b.corners &&
           a.face_offsets == b.face_offsets && f.corners == g.corners && f.poles == g.poles &&
           f.circles.size() == g.circles.size() && f.planes.size() == g.planes.size() && same_creases();
}

}  // namespace

/// The tables of the last topology: a drag changes positions only.
struct Pipeline::Memory {
    QuadMesh control;
    SubdivideOptions options;
    std::optional<Subdivider> subdivider;

    Result<QuadMesh> refine(QuadMesh&& mesh, const SubdivideOptions& wanted, const Progress& progress) {
        const bool known = subdivider && options.levels == wanted.levels && options.limit == wanted.limit &&
                           same_topology(control, mesh);
        if (!known || !subdivider->refine(mesh)) {
            auto built = Subdivider::build(mesh, wanted, progress);
            if (!built) {
                subdivider.reset();
                return fail(built.error());
            }
            subdivider.emplace(std::move(*built));
        }
        control = std::move(mesh);
        options = wanted;
        return subdivider->mesh();
    }
};

Pipeline::Pipeline() : memory_(std::make_unique<Memory>()) {}
Pipeline::~Pipeline() = default;

LiveMesh Pipeline::run(const Document& document, const MeshOptions& options, const Progress& progress,
                       bool with_buffers) {
    LiveMesh result;
    result.options = options;
    Watch watch;
    if (auto sound = validate(document); !sound) {
        result.error = sound.error();
        return result;
    }
    const bool limit = options.to_limit && options.level > 0;
    auto skinned =
        skin(document,
             {.sides = options.sides, .fit = limit ? Fit::limit : Fit::control, .repair = options.repair},
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
    if (options.level > 0) {
        auto finer =
            memory_->refine(std::move(skinned->mesh), {.levels = options.level, .limit = limit}, progress);
        if (!finer) {
            result.error = finer.error();
            return result;
        }
        skinned->mesh = std::move(*finer);
        result.subdivide_ms = watch.lap();
    }
    result.mesh = std::make_shared<const QuadMesh>(std::move(skinned->mesh));
    if (with_buffers) result.buffers = std::make_shared<const MeshBuffers>(mesh_buffers(*result.mesh));
    result.buffers_ms = watch.lap();
    return result;
}

void measure(LiveMesh& mesh) {
    const Topology topology = build_topology(*mesh.mesh);
    mesh.validation = validate(*mesh.mesh, topology);
    mesh.measures = measure(*mesh.mesh, topology);
}

}  // namespace sinew::modeler
