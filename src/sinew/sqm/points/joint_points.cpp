#include "sinew/sqm/points/joint_points.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sinew/base/portable_math.h"
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
            *at++ = along(from_ball_space(body, p_.vertices[v]));
        for (std::int32_t a = p_.arc_first[joint]; a < p_.arc_first[joint + 1]; ++a) {
            divide_arc(p_, p_.arcs[a], r_.pieces[a], at);
            if (!surfaces_.pits.empty() && r_.pieces[a] > 4) gather_in_groove(p_.arcs[a], r_.pieces[a], at);
            for (std::int32_t i = 1; i < r_.pieces[a]; ++i, ++at) *at = along(from_ball_space(body, *at));
        }
    }

  private:
    Vec3 along(const Vec3& ray) const {
        const double distance = reach_of_joint(n_, surfaces_, joint_, centre_, ray);
        double way = distance;
        for (const CellRoom& room : rooms_) way = std::min(way, room.way_out(centre_, ray, distance));
        return centre_ + way * ray;
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
    void gather_in_groove(const CellArc& arc, std::int32_t pieces, Vec3* inner) const {
        if (!is_pit(arc.left) || !is_pit(arc.right)) return;
        constexpr std::int32_t samples = 65;
        constexpr double longest_outside = 0.25;  // radians
        std::array<Vec3, samples + 2> ray;
        ray.front() = p_.vertices[arc.from], ray.back() = p_.vertices[arc.to];
        divide_arc(p_, arc, samples + 1, &ray[1]);
        const auto ray_at = [&](double at) -> Vec3 {
            const auto low = std::clamp(static_cast<std::int32_t>(at), 0, samples);
            return (ray[low] + (at - low) * (ray[low + 1] - ray[low])).normalized();
        };
        const auto in_groove = [&](double at) {
            return leads_into_dent(n_, surfaces_, joint_, centre_,
                                   from_ball_space(surfaces_.body[joint_], ray_at(at)));
        };
        std::int32_t first = 0, last = samples + 1;
        while (first <= samples && !in_groove(first)) ++first;
        while (last > first && !in_groove(last)) --last;
        if (first > samples || (first == 0 && last > samples)) return;
        const auto rim = [&](double inside, double outside) {
            for (int i = 0; i < 30; ++i) {
                const double middle = 0.5 * (inside + outside);
                (in_groove(middle) ? inside : outside) = middle;
            }
            return outside;
        };
        // An end in the groove, where more than two dents meet, is in the middle of its floor.
        const double from = first > 0 ? rim(first, first - 1) : 0,
                     to = last <= samples ? rim(last, last + 1) : samples + 1;
        // A long way outside gets a point of its own, or its edge would cut a furrow into the surface.
        const double sample = arc_length(p_, arc) / (samples + 1);
        const bool long_from = from * sample > longest_outside,
                   long_to = (samples + 1 - to) * sample > longest_outside;
        if (long_from) inner[0] = ray_at(0.5 * from);
        if (long_to) inner[pieces - 2] = ray_at(0.5 * (to + samples + 1));
        const std::int32_t begin = first > 0 ? (long_from ? 1 : 0) : -1,
                           end = last <= samples ? pieces - 2 - (long_to ? 1 : 0) : pieces - 1;
        const double start = first > 0 ? 0 : 0.5 * M_PI, stop = last <= samples ? M_PI : 0.5 * M_PI;
        const auto height = [](double angle) { return portable::sine_cosine(angle).cosine; };
        for (std::int32_t i = std::max(begin, 0); i <= std::min(end, pieces - 2);
             ++i) {  // evenly down the wall, over the floor and up again
            const double angle = start + (stop - start) * (i - begin) / (end - begin);
            const double share = (height(start) - height(angle)) / (height(start) - height(stop));
            inner[i] = ray_at(from + share * (to - from));
        }
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
