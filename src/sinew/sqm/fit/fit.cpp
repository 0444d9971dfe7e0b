#include "sinew/sqm/fit/fit.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sinew/mesh/limit.h"
#include "sinew/sqm/fit/balance.h"
#include "sinew/sqm/fit/fit_round_ends.h"
#include "sinew/sqm/fit/leeway.h"
#include "sinew/sqm/surface/dents.h"

namespace sinew::sqm {
namespace {

constexpr std::uint8_t fit_steps =
    8;  // with 4 a limb is dented by 3 % of its radius beside a branch, with 8 by less than 2.5 %
constexpr double steepest_fitted = 0.3;  // cosine of a wall to its ray, in grooves

/// Round cones meet in creases, and faces at joints are of all sizes: a smooth surface that passes through
/// all points there swells between them. One step makes up for the width that it lacks, and leaves it fair;
/// with four sides, where a third is lacking, three do.
std::uint8_t joint_steps(std::int32_t sides) { return sides > 4 ? 1 : 3; }

constexpr std::int32_t lone_sides = 8;  // of a lone node's sphere: of a cube's corners, edges and faces

/// What the number of its sides makes of a ring.
struct RingFactors {
    float gain;    ///< by how many times what it lacks its points have to move out
    double wider;  ///< target: passes through a circle as far outside of it as inside
    double held;   ///< control points that have it: as if the rings on both sides were the same

    explicit RingFactors(std::int32_t sides)
        : gain(static_cast<float>(1 / ring_limit_radius(sides))),
          wider(ring_fit_radius(sides)),
          held(wider / ring_limit_radius(sides)) {}
};

/// How a vertex may move: along a line, or in the plane at right angles to one; along none it stays.
struct Freedom {
    Vec3f axis = Vec3f::Zero();
    Vec3f lack =
        Vec3f::Zero();  ///< how far along the line, of what the limit lacks: the axis, or oblique to it
    bool in_plane = false;
    float gain = 1;           ///< by how many times what is lacking
    std::uint8_t steps = 0;   ///< and how often
    std::int32_t joint = -1;  ///< balanced over the faces round it, by the round cones of this joint
    std::uint32_t before = no_vertex,
                  after = no_vertex;  ///< the next one of the column, where the tube tapers
};

class Fitter {
  public:
    Fitter(const Parts& parts, const Bridge& bridge)
        : d_(parts), n_(parts.network), b_(bridge), freedom_(bridge.mesh.vertex_count()) {
        targets_.reserve(bridge.mesh.vertex_count());
        for (const Vec3f& position : bridge.mesh.positions) targets_.push_back(position.cast<double>());
        leeway_.resize(targets_.size());
        std::int32_t most = lone_sides;
        for (const std::int32_t sides : parts.refinement.path_sides) most = std::max(most, sides);
        for (std::int32_t sides = 0; sides <= most; ++sides)
            factors_.emplace_back(std::max(sides, 3));  // no ring has fewer
    }

    Result<std::vector<Vec3>> run() {
        joints();
        // A path has its vertices and poles to itself.
        tbb::parallel_for(tbb::blocked_range<std::int32_t>(0, n_.path_count(), 64), [&](const auto& range) {
            for (std::int32_t p = range.begin(); p < range.end(); ++p) path(p);
        });
        std::uint32_t vertex = b_.lone_vertex;
        for (const std::int32_t node : n_.lone)
            for (std::size_t i = 0; i < lone_sphere_points().size(); ++i)
                from(vertex++, d_.skeleton.position[node], lone_sides);
        // Half of the vertices stay: rings of round ends and those that hold a tube beside them.
        std::vector<char> moves(freedom_.size());
        for (std::size_t v = 0; v < moves.size(); ++v) moves[v] = !freedom_[v].lack.isZero(0);
        const auto stencils = build_limit_stencils(b_.mesh, moves);
        if (!stencils) return fail(stencils.error());
        return iterate(*stencils, moves);
    }

  private:
    void from(std::uint32_t vertex, const Vec3& centre, std::int32_t sides, std::uint8_t steps = fit_steps) {
        freedom_[vertex].axis = freedom_[vertex].lack =
            (targets_[vertex] - centre).normalized().cast<float>();
        freedom_[vertex].gain = factors_[sides].gain;
        freedom_[vertex].steps = steps;
    }
    /// A groove's walls are too steep for its points to move along rays: they do along the normals. Its rim
    /// stays. False for points outside.
    bool in_groove(std::uint32_t vertex, std::int32_t joint) {
        if (!has_groove(d_.surfaces, joint)) return false;
        const Vec3& centre = d_.skeleton.position[n_.joint_node[joint]];
        const DentWall wall = nearest_wall(d_.surfaces, joint, targets_[vertex]);
        if (!in_dent(n_, d_.surfaces, joint, centre, targets_[vertex])) return wall.touches;
        if (wall.normal.dot((targets_[vertex] - centre).normalized()) < steepest_fitted) return true;
        Freedom& freedom = freedom_[vertex];
        freedom.axis = freedom.lack = wall.normal.cast<float>();
        freedom.gain = factors_[joint_sides_[joint]].gain;
        freedom.steps = fit_steps;
        return true;
    }
    /// How much wider a dent's rings are to be made: as those of tubes are, as far as the joint's cell has
    /// room for its rim.
    double widening_of_dent(std::int32_t p, std::int32_t rim) const {
        const Station& ring = d_.stations.stations[rim];
        const auto sides = static_cast<std::size_t>(d_.refinement.path_sides[p]);
        std::vector<std::uint32_t> border;
        joint_ring_of_path(d_, p, ring.far ? 1 : 0, border);
        const Vec3f* at = &b_.mesh.positions[first_of_ring(d_, b_, p, rim)];
        double wider = factors_[sides].held;
        for (std::size_t k = 0; k < sides; ++k) {
            const double room = (targets_[border[k]] - ring.centre).norm(),
                         wide = (at[k].cast<double>() - ring.centre).norm();
            wider = std::min(wider, widest_rim * room / wide);
        }
        return std::max(1.0, wider);
    }
    /// The rings of the dent that a path leads into, if it does: their points move up and down; as a whole
    /// they are made wider.
    void dent(std::int32_t p) {
        const Stations& s = d_.stations;
        const auto is_pit = [&](std::int32_t i) { return s.stations[i].shape == RingShape::pit; };
        std::int32_t rim = s.first[p];
        while (rim < s.first[p + 1] && !(is_pit(rim) && s.stations[rim].share == 1)) ++rim;
        if (rim == s.first[p + 1]) return;
        const PathEnd& end = n_.path_end[p][s.stations[rim].far ? 1 : 0];
        const bool merged = merges(d_.surfaces, end.joint, n_.slot_first[end.joint] + end.slot);
        const double wider = merged ? 1 : widening_of_dent(p, rim);
        for (std::int32_t i = s.first[p]; i < s.first[p + 1]; ++i)
            if (is_pit(i)) dent_ring(p, i, merged ? end.joint : -1, wider);
    }
    /// @param groove  the joint whose groove the ring is in; -1 if in none
    void dent_ring(std::int32_t p, std::int32_t i, std::int32_t groove, double wider) {
        const Station& ring = d_.stations.stations[i];
        const std::int32_t sides = d_.refinement.path_sides[p];
        const std::uint32_t first = first_of_ring(d_, b_, p, i);
        for (std::uint32_t v = first; v < first + sides; ++v) {
            if (groove >= 0) {
                from_joint(v, groove);
                continue;
            }
            freedom_[v].axis = freedom_[v].lack = ring.tangent.cast<float>();
            freedom_[v].gain = factors_[sides].gain;
            freedom_[v].steps = fit_steps;
            const Vec3 out = targets_[v] - ring.centre;
            targets_[v] += (wider - 1) * (out - out.dot(ring.tangent) * ring.tangent);
        }
    }
    /// Balls are to be round, and their points are spread evenly, but not beside dents.
    std::uint8_t steps_at(std::int32_t joint) const {
        const Form* body = d_.surfaces.body[joint];
        if (!body || body->kind == Form::Kind::blend) return joint_steps(joint_sides_[joint]);
        return has_dents(d_.surfaces, joint) ? 2 : fit_steps;
    }
    /// Points of a joint move along its rays, but for those in grooves. On an ellipsoid by what is lacking
    /// along its normals: a limit beside the ray may well be on the surface.
    void from_joint(std::uint32_t vertex, std::int32_t joint) {
        const Vec3& centre = d_.skeleton.position[n_.joint_node[joint]];
        if (in_groove(vertex, joint)) return;
        const Form* body = d_.surfaces.body[joint];
        from(vertex, centre, joint_sides_[joint], steps_at(joint));
        if (d_.surfaces.only_cones[joint]) freedom_[vertex].joint = joint;
        if (!body || body->kind != Form::Kind::ball) return;
        const Vec3 ray = targets_[vertex] - centre;
        Vec3 normal = Vec3::Zero();
        double inside = 0;  // the ellipsoid is where this is 1
        for (const auto& [axis, half] :
             {std::pair(body->x, body->half.x()), {body->y, body->half.y()}, {body->z, body->half.z()}}) {
            const double part = ray.dot(axis) / half;
            inside += part * part;
            normal += part / half * axis;
        }
        if (std::abs(inside - 1) < 1e-5)
            freedom_[vertex].lack = (ray.norm() / ray.dot(normal) * normal).cast<float>();
    }
    void joints() {
        joint_sides_.assign(n_.joint_count(), std::numeric_limits<std::int32_t>::max());
        for (std::int32_t j = 0; j < n_.joint_count(); ++j)
            n_.for_slots(j, [&](std::int32_t, std::int32_t p) {
                joint_sides_[j] = std::min(joint_sides_[j], d_.refinement.path_sides[p]);
            });
        for (std::int32_t j = 0; j < n_.joint_count(); ++j)
            for (std::uint32_t v = d_.points.first[j]; v < d_.points.first[j + 1]; ++v) from_joint(v, j);
        std::int32_t j = 0;
        for (std::size_t i = 0; i < b_.capped.size(); ++i) {
            while (d_.polyhedra.cell_first[j + 1] <= b_.capped[i]) ++j;
            from_joint(b_.capped_pole + static_cast<std::uint32_t>(i), j);
        }
    }
    void path(std::int32_t p) {
        const Stations& s = d_.stations;
        for (std::int32_t i = s.first[p]; i < s.first[p + 1]; ++i) {
            const Station& ring = s.stations[i];
            const bool tube =
                ring.shape == RingShape::node || (ring.shape == RingShape::circle && !ring.round);
            if (ring.shape != RingShape::pit) path_ring(p, i, tube);
            if (tube) along_tapers(p, i);
        }
        if (!d_.surfaces.pits.empty()) dent(p);
        const double held = factors_[d_.refinement.path_sides[p]].held;
        const std::array<bool, 2> round = fit_round_ends(d_, b_, p, held, targets_);
        for (int end = 0; end < 2; ++end)
            if (b_.path_pole[p][end] != no_vertex && !round[end]) path_pole(p, end);
    }
    void path_ring(std::int32_t p, std::int32_t i, bool tube) {
        const Station& ring = d_.stations.stations[i];
        const PathEnd& end = n_.path_end[p][ring.far ? 1 : 0];
        const std::int32_t sides = d_.refinement.path_sides[p];
        const RingFactors& factors = factors_[sides];
        const std::uint32_t first = first_of_ring(d_, b_, p, i);
        for (std::uint32_t v = first; v < first + sides; ++v) {
            if (ring.shape == RingShape::follow) {
                from_joint(v, end.joint);
                continue;
            }
            Vec3& target = targets_[v];
            if (ring.fit != RingFit::through) {
                if (ring.fit == RingFit::held) target = ring.centre + factors.held * (target - ring.centre);
                continue;  // as it stands, or with its round end
            }
            Freedom& freedom = freedom_[v];
            freedom.axis = freedom.lack = ring.tangent.cast<float>();
            freedom.in_plane = true;
            freedom.gain = factors.gain;
            freedom.steps = fit_steps;
            // A smooth ring through the points of a circle runs inside it between them: half of that is
            // given back.
            if (!tube) continue;
            target = ring.centre + factors.wider * (target - ring.centre);
            leeway_[v] = leeway_of_ring(d_.skeleton, ring, sides, target);
        }
    }
    void along_tapers(std::int32_t p, std::int32_t i) {
        const Stations& s = d_.stations;
        const std::int32_t sides = d_.refinement.path_sides[p];
        const Station& ring = s.stations[i];
        const bool is_first = i == s.first[p], is_last = i + 1 == s.first[p + 1];
        const bool before = !is_first && tapers(s.stations[i - 1], ring),
                   after = !is_last && tapers(ring, s.stations[i + 1]);
        const std::uint32_t first = first_of_ring(d_, b_, p, i);
        for (std::uint32_t v = first; v < first + sides; ++v) {
            freedom_[v].before = is_first ? tip(p, 0) : before ? v - sides : no_vertex;
            freedom_[v].after = is_last ? tip(p, 1) : after ? v + sides : no_vertex;
        }
    }
    void path_pole(std::int32_t p, int end) {
        const auto nodes = n_.nodes(p);
        const std::int32_t other = end == 0 ? nodes[1] : nodes[nodes.size() - 2];
        const PathEnd& far = n_.path_end[p][1 - end];
        const std::uint32_t pole = b_.path_pole[p][end];
        if (far.at_joint() && nodes.size() == 2)
            from_joint(pole, far.joint);
        else
            from(pole, d_.skeleton.position[other], d_.refinement.path_sides[p]);
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

    /// Vertex -> the joint by whose round cones it is balanced. What lies in a plane or on a crease stays there: its
    /// place is not that of the round cones alone.
    std::vector<std::int32_t> balanced() const {
        std::vector<std::int32_t> joint(freedom_.size());
        for (std::size_t v = 0; v < joint.size(); ++v) joint[v] = freedom_[v].joint;
        const Features& features = b_.mesh.features;
        for (const std::uint32_t v : features.corners) joint[v] = -1;
        for (const Crease& crease : features.creases)
            for (const std::uint32_t v : crease.edge) joint[v] = -1;
        for (const Plane& plane : features.planes)
            for (const std::uint32_t f : plane.faces)
                for (const std::uint32_t v : b_.mesh.face(f)) joint[v] = -1;
        return joint;
    }
    /// Balls, dents and lone nodes are round by themselves, and may need all that they ask for.
    std::vector<char> limited(const PointGroups& groups) const {
        std::vector<char> limited(freedom_.size());
        for (std::size_t v = 0; v < limited.size(); ++v) {
            const std::int32_t group = groups.of[v];
            const RingShape shape =
                group < groups.rings ? d_.stations.stations[group].shape : RingShape::follow;
            limited[v] = shape == RingShape::follow ? freedom_[v].joint >= 0 : shape != RingShape::pit;
        }
        return limited;
    }

    std::vector<Vec3> iterate(const LimitStencils& stencils, const std::vector<char>& moves) {
        std::vector<std::uint32_t> moving;
        for (std::size_t v = 0; v < moves.size(); ++v)
            if (moves[v]) moving.push_back(static_cast<std::uint32_t>(v));
        std::vector<Vec3> control = targets_, limit(targets_.size());
        if (moving.empty()) return control;
        const PointGroups groups = group_points(d_, b_);
        for (std::size_t v = 0; v < leeway_.size(); ++v)
            if (leeway_[v].ray.isZero(0)) leeway_[v].start = targets_[v];
        limit_by_edges(b_.mesh, groups, limited(groups), leeway_);
        Balance balance(d_, b_.mesh, balanced());
        for (int step = 0; step < fit_steps; ++step) {
            limit_positions(stencils, std::span<const Vec3>(control), limit);
            balance.measure(control, limit);
            tbb::parallel_for(
                tbb::blocked_range<std::size_t>(0, moving.size(), 2048), [&](const auto& range) {
                    for (std::size_t i = range.begin(); i < range.end(); ++i) {
                        const std::uint32_t v = moving[i];
                        control[v] =
                            within(leeway_[v],
                                   control[v] + (balance.balances(v) ? out_of_balance(balance, v, limit[v])
                                                                     : lacking(step, v, limit[v])));
                    }
                });
        }
        unfold(b_.mesh, groups, leeway_, moving, control);
        return control;
    }
    Vec3 out_of_balance(const Balance& balance, std::uint32_t v, const Vec3& limit) const {
        return -balance.mean_outside(v, limit) * freedom_[v].axis.cast<double>();
    }
    /// What the smooth surface lacks at a vertex, as far as it may be given in this step.
    Vec3 lacking(int step, std::uint32_t v, const Vec3& limit) const {
        const Freedom& freedom = freedom_[v];
        if (step >= freedom.steps) return Vec3::Zero();
        const Vec3 axis = freedom.axis.cast<double>();
        const Vec3 lack = target_at(v, limit, axis) - limit;
        const Vec3 along = lack.dot(freedom.lack.cast<double>()) * axis;
        return freedom.gain * (freedom.in_plane ? Vec3(lack - along) : along);
    }

    const Parts& d_;
    const Network& n_;
    const Bridge& b_;
    std::vector<Vec3> targets_;
    std::vector<Freedom> freedom_;
    std::vector<Leeway> leeway_;
    std::vector<RingFactors> factors_;       ///< by the number of sides
    std::vector<std::int32_t> joint_sides_;  ///< joint -> of its path of fewest sides
};

}  // namespace

Result<void> fit_limit(const Parts& parts, Bridge& bridge) {
    const auto control = Fitter(parts, bridge).run();
    if (!control) return fail(control.error());
    for (std::size_t v = 0; v < control->size(); ++v) bridge.mesh.positions[v] = (*control)[v].cast<float>();
    return {};
}

}  // namespace sinew::sqm
