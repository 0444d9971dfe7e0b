#include "sinew/smooth/smooth_skin.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace sinew {
namespace {

class Watch {
  public:
    /// Seconds since the last call.
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
    }

  private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

Fit fit_of(const SmoothSkinOptions& options) {
    return options.fit.value_or(options.levels > 0 ? Fit::limit : Fit::control);
}

/// Whoever wants the radii on the limit surface wants the vertices there too: those of a coarse level stand
/// further out.
SubdivideOptions finer_options(const SmoothSkinOptions& options) {
    return {.levels = options.levels, .limit = fit_of(options) == Fit::limit, .memory = options.memory};
}

/// @param finer  replaces the control mesh by the subdivided one: finer(mesh, options, progress)
template <class Finer>
Result<SmoothSkin> make(const Document& document, const SmoothSkinOptions& options, const Progress& progress,
                        const Finer& finer) {
    const double half = options.levels != 0 ? 0.5 : 1;
    Watch watch;
    auto skinned = skin(document,
                        {.sides = options.sides,
                         .fit = fit_of(options),
                         .repair = options.repair,
                         .stage = options.stage,
                         .blend = options.blend,
                         .density = options.density},
                        progress.part(0, half));
    if (!skinned) return fail(skinned.error());
    SmoothSkin made{.skin = std::move(*skinned), .skin_seconds = watch.lap()};
    if (options.levels == 0) return made;
    if (const auto done = finer(made.skin.mesh, finer_options(options), progress.part(half, 1)); !done)
        return fail(done.error());
    made.subdivide_seconds = watch.lap();
    return made;
}

bool same_creases(const Features& f, const Features& g) {
    return std::equal(
        f.creases.begin(), f.creases.end(), g.creases.begin(), g.creases.end(),
        [](const Crease& a, const Crease& b) { return a.edge == b.edge && a.sharpness == b.sharpness; });
}

/// Do the meshes differ at most in what Subdivider::refine can move?
bool same_topology(const QuadMesh& a, const QuadMesh& b) {
    const Features &f = a.features, &g = b.features;
    const auto same_edges = [](const Circle& c, const Circle& d) { return c.edges == d.edges; };
    const auto same_faces = [](const Plane& p, const Plane& q) { return p.faces == q.faces; };
    return a.vertex_count() == b.vertex_count() && a.corners == b.corners &&
           a.face_offsets == b.face_offsets && f.corners == g.corners && f.poles == g.poles &&
           std::equal(f.circles.begin(), f.circles.end(), g.circles.begin(), g.circles.end(), same_edges) &&
           std::equal(f.planes.begin(), f.planes.end(), g.planes.begin(), g.planes.end(), same_faces) &&
           same_creases(f, g);
}

bool same_tables(const SubdivideOptions& a, const SubdivideOptions& b) {
    return a.levels == b.levels && a.limit == b.limit && a.memory == b.memory;
}

}  // namespace

Result<SmoothSkin> smooth_skin(const Document& document, const SmoothSkinOptions& options,
                               const Progress& progress) {
    const auto finer = [](QuadMesh& mesh, const SubdivideOptions& wanted,
                          const Progress& rest) -> Result<void> {
        auto fine = subdivide(mesh, wanted, rest);
        if (!fine) return fail(fine.error());
        mesh = std::move(*fine);
        return {};
    };
    return make(document, options, progress, finer);
}

Result<SmoothSkin> SmoothSkinner::operator()(const Document& document, const SmoothSkinOptions& options,
                                             const Progress& progress) {
    const auto finer = [this](QuadMesh& mesh, const SubdivideOptions& wanted,
                              const Progress& rest) -> Result<void> {
        const auto fine = refine(mesh, wanted, rest);
        if (!fine) return fail(fine.error());
        control_ = std::move(mesh);
        mesh = **fine;
        return {};
    };
    return make(document, options, progress, finer);
}

Result<const QuadMesh*> SmoothSkinner::refine(const QuadMesh& control, const SubdivideOptions& options,
                                              const Progress& progress) {
    const bool known = subdivider_ && same_tables(options_, options) && same_topology(control_, control);
    if (!known || !subdivider_->refine(control)) {
        subdivider_.reset();
        auto built = Subdivider::build(control, options, progress);
        if (!built) return fail(built.error());
        subdivider_.emplace(std::move(*built));
        options_ = options;
    }
    return &subdivider_->mesh();
}

}  // namespace sinew
