#include "sinew/sqm/points/joint_points.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "sinew/base/portable_math.h"
#include "sinew/sqm/surface/bisect.h"
#include "sinew/sqm/surface/cell_room.h"
#include "sinew/sqm/surface/dents.h"
#include "sinew/sqm/surface/joint_reach.h"

namespace sinew::sqm {
namespace {

void lay_out(const Network& n, const Polyhedra& p, const Refinement& r, JointPoints& points) {
    points.first.resize(n.joint_count() + 1);
    points.arc_first.resize(p.arcs.size());
    std::uint32_t next = 0;
    for (std::int32_t j = 0; j < n.joint_count(); ++j) {
        points.first[j] = next;
        next += p.vertex_first[j + 1] - p.vertex_first[j];
        for (std::int32_t a = p.arc_first[j]; a < p.arc_first[j + 1]; ++a) {
            points.arc_first[a] = next;
            next += r.pieces[a] - 1;
        }
    }
    points.first.back() = next;
    points.position.resize(next);
}

/// Pieces with which an arc can follow a groove: to one rim, down, over the floor, up and from the other rim.
constexpr std::int32_t least_across_groove = 5;
/// Edges longer than this outside of a groove, in radians, get a point of their own half way: one straight to
/// the rim would lie as deep below a ball as 1 - cos(0.25 / 2) = 0.8 % of its radius, a furrow that shows.
constexpr double longest_outside = 0.25;

/// An arc between two cells as a curve of unit directions, by even samples: its parameter counts them.
class SampledArc {
  public:
    /// The parameter of the arc's end. No arc is longer than pi, so samples are at most 0.048 radians apart:
    /// only a groove narrower than that can be missed.
    static constexpr std::int32_t end = 66;

    SampledArc(const Polyhedra& p, const CellArc& arc) {
        directions_.front() = p.vertices[arc.from], directions_.back() = p.vertices[arc.to];
        divide_arc(p, arc, end, &directions_[1]);
    }
    Vec3 at(double parameter) const {
        const auto low = std::clamp(static_cast<std::int32_t>(parameter), 0, end - 1);
        return (directions_[low] + (parameter - low) * (directions_[low + 1] - directions_[low]))
            .normalized();
    }

  private:
    std::array<Vec3, end + 1> directions_;
};

/// From one parameter of a curve to another.
struct Stretch {
    double begin = 0, end = 0;
    bool from_start = false, to_end = false;  ///< it begins, ends where the curve does

    bool is_empty() const { return begin >= end; }
    bool is_whole() const { return from_start && to_end; }
};

/// The stretch of a curve from the first to the last direction that `holds`, bounded by ones that do not.
template <class Holds>
Stretch find_stretch(const SampledArc& curve, Holds holds) {
    constexpr int halvings = 30;  // of a sample: to 1e-9 of it
    const auto holds_at = [&](double parameter) { return holds(curve.at(parameter)); };
    std::int32_t first = 0, last = SampledArc::end;
    while (first < SampledArc::end && !holds_at(first)) ++first;
    while (last > first && !holds_at(last)) --last;
    if (first == SampledArc::end) return {};
    const bool from_start = first == 0, to_end = last == SampledArc::end;
    return {from_start ? 0 : bisect(first, first - 1, halvings, holds_at).second,
            to_end ? SampledArc::end : bisect(last, last + 1, halvings, holds_at).second, from_start, to_end};
}

/// Puts the inner points of an arc onto the stretch of it that crosses a groove: at equal angles of a half
/// turn from one rim down the wall, over the floor and up to the other. Where the arc has one of its own ends
/// in the groove, because more than two dents meet there, that end is the middle of the floor, and the points
/// take a quarter turn from it to the rim.
/// @param longest_outside  what is longer outside of the groove keeps a point in its middle; a parameter's
void spread_over_groove(const SampledArc& curve, const Stretch& groove, double longest_outside,
                        std::span<Vec3> inner) {
    const auto count = static_cast<std::int32_t>(inner.size());
    const double after = SampledArc::end - groove.end;
    const bool point_before = groove.begin > longest_outside, point_after = after > longest_outside;
    if (point_before) inner.front() = curve.at(0.5 * groove.begin);
    if (point_after) inner.back() = curve.at(0.5 * (groove.end + SampledArc::end));
    // Counted as inner points are, the arc's own ends are -1 and `count`.
    const std::int32_t first = groove.from_start ? -1
                               : point_before    ? 1
                                                 : 0,
                       last = groove.to_end ? count
                              : point_after ? count - 2
                                            : count - 1;
    const double first_angle = groove.from_start ? 0.5 * M_PI : 0,
                 last_angle = groove.to_end ? 0.5 * M_PI : M_PI;
    const auto height = [](double angle) { return portable::sine_cosine(angle).cosine; };
    for (std::int32_t i = std::max(first, 0); i <= std::min(last, count - 1); ++i) {
        const double angle = first_angle + (last_angle - first_angle) * (i - first) / (last - first);
        const double across =
            (height(first_angle) - height(angle)) / (height(first_angle) - height(last_angle));
        inner[i] = curve.at(groove.begin + across * (groove.end - groove.begin));
    }
}

/// Casts the points of one joint onto its surface.
class Caster {
  public:
    Caster(const Plain& skeleton, const Network& n, const Polyhedra& p, const Refinement& r,
           const JointSurfaces& surfaces, JointPoints& points)
        : s_(skeleton), n_(n), p_(p), r_(r), surfaces_(surfaces), points_(points) {}

    void cast(std::int32_t joint) {
        joint_ = joint;
        centre_ = s_.position[n_.joint_node[joint]];
        const Form* body = surfaces_.body[joint];
        if (body && body->kind == Form::Kind::box) return box(*body);
        rooms_.clear();
        if (!body) find_rooms();
        Vec3* at = &points_.position[points_.first[joint]];
        for (std::int32_t v = p_.vertex_first[joint]; v < p_.vertex_first[joint + 1]; ++v)
            *at++ = on_surface(from_ball_space(body, p_.vertices[v]));
        for (std::int32_t a = p_.arc_first[joint]; a < p_.arc_first[joint + 1]; ++a) {
            divide_arc(p_, p_.arcs[a], r_.pieces[a], at);
            if (!surfaces_.pits.empty() && r_.pieces[a] >= least_across_groove)
                gather_in_groove(p_.arcs[a], r_.pieces[a], at);
            for (std::int32_t i = 1; i < r_.pieces[a]; ++i, ++at)
                *at = on_surface(from_ball_space(body, *at));
        }
    }

  private:
    Vec3 on_surface(const Vec3& ray) const {
        const double reach = reach_of_joint(n_, surfaces_, joint_, centre_, ray);
        double distance = reach;
        for (const CellRoom& room : rooms_)
            distance = std::min(distance, room.free_distance(centre_, ray, reach));
        return centre_ + distance * ray;
    }
    /// A bone too short for the joints at both its ends: this one stays within the cell of the other.
    void find_rooms() {
        for (std::int32_t slot = n_.slot_first[joint_]; slot < n_.slot_first[joint_ + 1]; ++slot) {
            if (!surfaces_.crowded[slot]) continue;
            const PathEnd& other = n_.path_end[n_.slot_path[slot].path][1 - n_.slot_path[slot].end];
            if (!surfaces_.body[other.joint])
                rooms_.emplace_back(s_, n_, p_, surfaces_, other.joint, other.slot);
        }
    }

    bool is_pit(std::int32_t cell) const {
        const std::int32_t slot = cell - p_.cell_first[joint_];
        return slot < n_.degree(joint_) && surfaces_.kind[n_.slot_first[joint_] + slot] == SlotKind::pit;
    }
    /// Between two dents that overlap, an arc crosses the groove that they make: its points go from one rim
    /// of that down the wall, over the floor and up to the other.
    /// @param inner  the arc's inner points, pieces - 1 of them, evenly spread; in and out
    void gather_in_groove(const CellArc& arc, std::int32_t pieces, Vec3* inner) const {
        if (!is_pit(arc.left) || !is_pit(arc.right)) return;
        const SampledArc curve(p_, arc);
        const Stretch groove = find_stretch(curve, [&](const Vec3& direction) {
            return leads_into_dent(n_, surfaces_, joint_, centre_,
                                   from_ball_space(surfaces_.body[joint_], direction));
        });
        if (groove.is_empty() || groove.is_whole()) return;
        const double radians = arc_length(p_, arc) / SampledArc::end;  // a unit of the curve's parameter
        spread_over_groove(curve, groove, longest_outside / radians, {inner, inner + pieces - 1});
    }

    /// Vertices are the corners, exactly; points on arcs are evenly spread along the edges.
    void box(const Form& f) {
        Vec3* at = &points_.position[points_.first[joint_]];
        const auto corner = [&](std::int32_t v) {
            const Vec3& ray = p_.vertices[v];
            Vec3 c = centre_;
            for (const auto& [axis, half] :
                 {std::pair(f.x, f.half.x()), {f.y, f.half.y()}, {f.z, f.half.z()}})
                c += (ray.dot(axis) < 0 ? -half : half) * axis;
            return c;
        };
        for (std::int32_t v = p_.vertex_first[joint_]; v < p_.vertex_first[joint_ + 1]; ++v)
            *at++ = corner(v);
        for (std::int32_t a = p_.arc_first[joint_]; a < p_.arc_first[joint_ + 1]; ++a) {
            const Vec3 from = corner(p_.arcs[a].from), to = corner(p_.arcs[a].to);
            for (std::int32_t i = 1; i < r_.pieces[a]; ++i)
                *at++ = from + (double(i) / r_.pieces[a]) * (to - from);
        }
    }

    const Plain& s_;
    const Network& n_;
    const Polyhedra& p_;
    const Refinement& r_;
    const JointSurfaces& surfaces_;
    JointPoints& points_;
    std::int32_t joint_ = 0;
    Vec3 centre_;
    std::vector<CellRoom> rooms_;
};

}  // namespace

JointPoints make_joint_points(const Plain& skeleton, const Network& n, const Polyhedra& p,
                              const Refinement& r, const JointSurfaces& surfaces) {
    JointPoints points;
    lay_out(n, p, r, points);
    tbb::parallel_for(tbb::blocked_range<std::int32_t>(0, n.joint_count(), 64), [&](const auto& range) {
        Caster caster(skeleton, n, p, r, surfaces, points);
        for (std::int32_t j = range.begin(); j < range.end(); ++j) caster.cast(j);
    });
    return points;
}

}  // namespace sinew::sqm
