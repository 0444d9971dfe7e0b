/// @file pipeline.h
/// From a document to what the viewport draws: skin, subdivide, buffers. A pure function with a memory for
/// speed.
#pragma once

#include <memory>
#include <optional>

#include "sinew/base/progress.h"
#include "sinew/mesh/measure.h"
#include "sinew/mesh/quad_mesh.h"
#include "sinew/render/mesh_buffers.h"
#include "sinew/skeleton/document.h"
#include "sinew/smooth/smooth_skin.h"

namespace sinew::modeler {

/// How the surface is made.
struct MeshOptions {
    int level = 1;  ///< of subdivision, 0 the control mesh
    bool to_limit =
        true;             ///< radii are those of the subdivided surface (Fit::limit); level 0 has them anyway
    int sides = 0;        ///< vertices round every tube; 0: as few as possible
    bool repair = false;  ///< a measured skeleton

    bool operator==(const MeshOptions&) const = default;
};

/// A surface and how it came about.
struct LiveMesh {
    std::uint64_t revision = 0;            ///< of the model, as ordered
    MeshOptions options;                   ///< as ordered
    std::shared_ptr<const QuadMesh> mesh;  ///< null where it failed
    std::shared_ptr<const MeshBuffers> buffers;
    std::optional<Error> error;
    Warnings warnings;
    std::int64_t components = 0, cycles = 0;
    std::int64_t irregular_at_most = 0;  ///< of the control mesh, by the formula
    double skin_ms = 0, subdivide_ms = 0, buffers_ms = 0;
    /// What the statistics panel shows; measured after the mesh was delivered, so absent at first.
    std::optional<Validation> validation;
    std::optional<Measures> measures;
};

/// Not for two threads at once: it remembers the subdivision of the last topology, since a drag changes only
/// positions.
class Pipeline {
  public:
    /// Buffers are left out where `with_buffers` is false (export).
    LiveMesh run(const Document& document, const MeshOptions& options, const Progress& progress = {},
                 bool with_buffers = true);

  private:
    SmoothSkinner skinner_;
};

/// Fills in validation and measures.
void measure(LiveMesh& mesh);

}  // namespace sinew::modeler
