#include "live/pipeline.h"

#include <chrono>

#include "document/images.h"
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

/// The document with the images of its symmetry drawn out; twins that coincide are one node.
Document drawn_out(const Document& document) {
    if (document.symmetry.kind == Symmetry::Kind::none) return document;
    Document result = document;
    result.symmetry = {};
    result.names.clear();
    result.extras.clear();
    const auto count = static_cast<std::int32_t>(document.nodes.size());
    std::int64_t id = 0;
    for (const Node& node : document.nodes) id = std::max(id, node.id + 1);
    for (Node& node : result.nodes)
        if (is_own_twin(document.symmetry, node.position, node.radius))
            node.position = onto_symmetry(document.symmetry, node.position);
    const std::vector<Mat3> images = images_of(document.symmetry);
    for (std::size_t k = 1; k < images.size(); ++k) {
        std::vector<std::int32_t> twin(count);
        for (std::int32_t i = 0; i < count; ++i) {
            Node node = document.nodes[i];
            twin[i] = i;
            if (is_own_twin(document.symmetry, node.position, node.radius)) continue;
            node.position = images[k] * node.position;
            node.id = id++;
            twin[i] = static_cast<std::int32_t>(result.nodes.size());
            result.nodes.push_back(node);
        }
        for (std::int32_t i = 0; i < count; ++i)
            if (const std::int32_t parent = document.nodes[i].parent; parent >= 0) {
                if (twin[i] != i)
                    result.nodes[twin[i]].parent = twin[parent];
                else if (twin[parent] != parent)
                    result.links.push_back({twin[parent], i});
            }
        for (auto [a, b] : document.links)
            if (twin[a] != a || twin[b] != b) result.links.push_back({twin[a], twin[b]});
    }
    return result;
}

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
    auto skinned =
        skin(drawn_out(document),
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
