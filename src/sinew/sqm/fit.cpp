#include "sinew/sqm/fit.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "sinew/mesh/limit.h"

namespace sinew::sqm {
namespace {

constexpr int steps = 16;

/// How a vertex may move: along a line, or in the plane at right angles to one.
struct Freedom {
    Vec3f axis = Vec3f::Zero();
    bool in_plane = false;
    std::uint32_t before = no_vertex,
                  after = no_vertex;  ///< the next one of the column, where the tube tapers
};

class Fitter {
  public:
    Fitter(const Parts& parts, const Bridge& bridge)
        : d_(parts), n_(parts.network), b_(bridge), freedom_(bridge.mesh.vertex_count()) {
        targets_.reserve(bridge.mesh.vertex_count());
        for (const Vec3f& position : bridge.mesh.positions) targets_.push_back(position.cast<double>());
    }

    Result<std::vector<Vec3>> run() {
        const auto stencils = build_limit_stencils(b_.mesh);
        if (!stencils) return fail(stencils.error());
        joints();
        for (std::int32_t p = 0; p < n_.path_count(); ++p) path(p);
        std::uint32_t vertex = b_.lone_vertex;
        for (const std::int32_t node : n_.lone)
            for (std::size_t i = 0; i < lone_sphere_points().size(); ++i)
                from(vertex++, d_.skeleton.position[node]);
        return iterate(*stencils);
    }

  private:
    void from(std::uint32_t vertex, const Vec3& centre) {
        freedom_[vertex] = {(targets_[vertex] - centre).normalized().cast<float>(), false};
    }
    void joints() {
        for (std::int32_t j = 0; j < n_.joint_count(); ++j)
            for (std::uint32_t v = d_.points.first[j]; v < d_.points.first[j + 1]; ++v)
                from(v, d_.skeleton.position[n_.joint_node[j]]);
        std::int32_t j = 0;
        for (std::size_t i = 0; i < b_.capped.size(); ++i) {
            while (d_.polyhedra.cell_first[j + 1] <= b_.capped[i]) ++j;
            from(b_.capped_pole + static_cast<std::uint32_t>(i), d_.skeleton.position[n_.joint_node[j]]);
        }
    }
    void path(std::int32_t p) {
        const Stations& s = d_.stations;
        const std::int32_t sides = d_.refinement.path_sides[p];
        const double wider = ring_fit_radius(sides);
        for (std::int32_t i = s.first[p]; i < s.first[p + 1]; ++i) {
            const Station& ring = s.stations[i];
            const std::uint32_t first = b_.path_vertex[p] + (i - s.first[p]) * sides;
            const bool tube =
                ring.shape == RingShape::node || (ring.shape == RingShape::circle && !ring.round);
            for (std::int32_t k = 0; k < sides; ++k) {
                Vec3& target = targets_[first + k];
                if (ring.shape == RingShape::follow) {
                    const PathEnd& end = n_.path_end[p][ring.far ? 1 : 0];
                    from(first + k, d_.skeleton.position[n_.joint_node[end.joint]]);
                    continue;
                }
                freedom_[first + k] = {ring.tangent.cast<float>(), ring.shape != RingShape::pit};
                // A smooth ring through the points of a circle runs inside it between them: half of that is
                // given back.
                if (tube) target = ring.centre + wider * (target - ring.centre);
            }
            if (!tube) continue;
            const bool is_first = i == s.first[p], is_last = i + 1 == s.first[p + 1];
            const bool before = !is_first && tapers(s.stations[i - 1], ring),
                       after = !is_last && tapers(ring, s.stations[i + 1]);
            for (std::uint32_t v = first; v < first + sides; ++v) {
                freedom_[v].before = is_first ? tip(p, 0) : before ? v - sides : no_vertex;
                freedom_[v].after = is_last ? tip(p, 1) : after ? v + sides : no_vertex;
            }
        }
        const auto nodes = n_.nodes(p);
        for (int end = 0; end < 2; ++end) {
            const std::uint32_t pole = b_.path_pole[p][end];
            if (pole == no_vertex) continue;
            const std::int32_t other = end == 0 ? nodes[1] : nodes[nodes.size() - 2];
            from(pole, d_.skeleton.position[other]);
        }
    }

    static bool tapers(const Station& ring, const Station& next) {
        return ring.to_next == BoneKind::tube && ring.shape != RingShape::follow &&
               next.shape != RingShape::follow &&
               std::abs(ring.half.sum() - next.half.sum()) > 0.05 * ring.half.sum();
    }

    std::uint32_t tip(std::int32_t p, int end) const {
        const auto nodes = n_.nodes(p);
        const bool is_tip = d_.skeleton.cap[end == 0 ? nodes.front() : nodes.back()] == Cap::point;
        return is_tip ? b_.path_pole[p][end] : no_vertex;
    }

    /// Where rings are unevenly spaced, the limit of one lies further along the tube than its target; what it
    /// should be there is on the line to the next ring's target.
    Vec3 target_at(std::size_t v, const Vec3& limit, const Vec3& axis) const {
        const Freedom& f = freedom_[v];
        const double beyond = (limit - targets_[v]).dot(axis);
        const std::uint32_t next = beyond > 0 ? f.after : f.before;
        if (next == no_vertex) return targets_[v];
        const Vec3 way = targets_[next] - targets_[v];
        const double length = way.dot(axis);
        return length * beyond > 0 ? Vec3(targets_[v] + std::min(1.0, beyond / length) * way) : targets_[v];
    }

    std::vector<Vec3> iterate(const LimitStencils& stencils) const {
        std::vector<Vec3> control = targets_, limit(targets_.size());
        for (int step = 0; step < steps; ++step) {
            limit_positions(stencils, std::span<const Vec3>(control), limit);
            tbb::parallel_for(tbb::blocked_range<std::size_t>(0, control.size(), 4096),
                              [&](const auto& range) {
                                  for (std::size_t v = range.begin(); v < range.end(); ++v) {
                                      const Vec3 axis = freedom_[v].axis.template cast<double>();
                                      const Vec3 lack = target_at(v, limit[v], axis) - limit[v];
                                      const Vec3 along = lack.dot(axis) * axis;
                                      control[v] += freedom_[v].in_plane ? Vec3(lack - along) : along;
                                  }
                              });
        }
        return control;
    }

    const Parts& d_;
    const Network& n_;
    const Bridge& b_;
    std::vector<Vec3> targets_;
    std::vector<Freedom> freedom_;
};

}  // namespace

Result<void> fit_limit(const Parts& parts, Bridge& bridge) {
    const auto control = Fitter(parts, bridge).run();
    if (!control) return fail(control.error());
    for (std::size_t v = 0; v < control->size(); ++v) bridge.mesh.positions[v] = (*control)[v].cast<float>();
    return {};
}

}  // namespace sinew::sqm
