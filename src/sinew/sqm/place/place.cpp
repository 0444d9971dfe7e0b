#include "sinew/sqm/place/place.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sinew/base/portable_math.h"
#include "sinew/sqm/place/bend_ring.h"
#include "sinew/sqm/place/dent_rings.h"
#include "sinew/sqm/place/follow_surface.h"
#include "sinew/sqm/surface/cell_room.h"
#include "sinew/sqm/surface/joint_reach.h"

namespace sinew::sqm {
namespace {

/// How far the ring of a bend may lean over the bone to the next one, of the bone's length: to the middle,
/// but for 2 % that stay between both. Of 3,000 chains of four random bones, as thick as they are long, 897
/// have a quad that is folded; with 0.6 it is 1,115, and without a limit 1,472.
constexpr double to_next_bend = 0.49;
/// The same of the bone to a joint, whose points end near the middle of it.
constexpr double to_joint = 0.5;
/// The same to a round end, of the straight side of the bone, which ends where the ring of that end stands
/// (with twice the side, 14 more of those chains have a folded quad); where the ball swallows all of the
/// side, a tenth of the bone is taken for it, or the ring would shrink to its centre.
constexpr double to_round_end = 0.9;
constexpr double least_side = 0.1;

class Placer {
  public:
    Placer(const Parts& parts, const PlaceOptions& options, Bridge& bridge)
        : d_(parts), n_(parts.network), options_(options), out_(bridge) {}

    void run() {
        QuadMesh& mesh = out_.mesh;
        mesh.vertex_node.resize(mesh.vertex_count());
        mesh.vertex_bone.resize(mesh.vertex_count(), -1);
        mesh.vertex_along.resize(mesh.vertex_count());
        joints();
        tbb::parallel_for(tbb::blocked_range<std::int32_t>(0, n_.path_count(), 128), [&](const auto& range) {
            for (std::int32_t p = range.begin(); p < range.end(); ++p) path(p);
        });
        capped();
        lone();
    }

  private:
    void set(std::uint32_t vertex, const Vec3& position, std::int32_t node) {
        out_.mesh.positions[vertex] = position.cast<float>();
        out_.mesh.vertex_node[vertex] = d_.skeleton.source_node[node];
    }

    Vec3 position(std::uint32_t vertex) const { return out_.mesh.positions[vertex].cast<double>(); }

    void joints() {
        tbb::parallel_for(tbb::blocked_range<std::int32_t>(0, n_.joint_count(), 128), [&](const auto& range) {
            for (std::int32_t j = range.begin(); j < range.end(); ++j) joint(j);
        });
    }
    void joint(std::int32_t j) {
        const std::int32_t node = n_.joint_node[j];
        const Vec3& centre = d_.skeleton.position[node];
        const double radius = d_.skeleton.radius[node];
        for (std::uint32_t v = d_.points.first[j]; v < d_.points.first[j + 1]; ++v) {
            const Vec3& point = d_.points.position[v];
            set(v, options_.ideal ? point : Vec3(centre + radius * (point - centre).normalized()), node);
        }
    }

    /// The vertices of a ring that stands by itself; column k is seen at angle(k) from ring.x.
    template <class Angle>
    void ring_vertices(std::int32_t i, std::int32_t p, std::span<Vec3f> to, Angle angle) const {
        const Station& ring = d_.stations.stations[i];
        const Vec3 y = ring.tangent.cross(ring.x);
        const auto put = [&](auto from_ray) {
            std::array<double, 16> angles;
            std::array<portable::SineCosine, 16> turned;
            for (std::size_t first = 0; first < to.size(); first += angles.size()) {
                const std::size_t count = std::min(angles.size(), to.size() - first);
                for (std::size_t k = 0; k < count; ++k) angles[k] = angle(first + k);
                portable::sine_cosine({angles.data(), count}, turned.data());
                for (std::size_t k = 0; k < count; ++k)
                    to[first + k] =
                        from_ray(turned[k].cosine * ring.x + turned[k].sine * y).template cast<float>();
            }
        };
        if (ring.shape == RingShape::outline) {
            for (std::size_t k = 0; k < to.size(); ++k)
                to[k] = on_outline(ring, p, static_cast<std::int32_t>(k)).cast<float>();
        } else if (ring.shape == RingShape::node && options_.ideal) {
            const BendRing bend = bend_ring(i, p);
            put([&](const Vec3& ray) { return bend.at(ray); });
        } else if (ring.half.x() == ring.half.y() && ring.bend.isZero(0)) {
            put([&](const Vec3& ray) -> Vec3 { return ring.centre + ring.half.x() * ray; });
        } else {
            put([&](const Vec3& ray) -> Vec3 { return ring.centre + widened(ring, ellipse(ring, ray)); });
        }
    }
    BendRing bend_ring(std::int32_t i, std::int32_t p) const {
        const Station& ring = d_.stations.stations[i];
        const ConeFrom before = cone_from(ring, ring.before), after = cone_from(ring, ring.after);
        BendRing bend(ring, before, after);
        bend.give_room(room_of(p, ring.before, before), room_of(p, ring.after, after));
        for (const bool back : {true, false})
            if (const Station* next = next_bend(i, p, back)) bend.keep_from(*next, back);
        return bend;
    }
    /// The ring at the next node of a path, if there is one: no more than a few stand between both.
    const Station* next_bend(std::int32_t i, std::int32_t p, bool back) const {
        const Stations& s = d_.stations;
        const std::int32_t first = s.first[p], count = s.first[p + 1] - first, step = back ? count - 1 : 1;
        const std::int32_t node = back ? s.stations[i].before : s.stations[i].after;
        std::int32_t at = i - first;
        for (std::int32_t tries = 0; tries < std::min(count, 8); ++tries) {
            at = (at + step) % count;
            const Station& next = s.stations[first + at];
            if (next.shape == RingShape::node && next.node == node) return &next;
        }
        return nullptr;
    }
    ConeFrom cone_from(const Station& ring, std::int32_t other) const {
        const Plain& s = d_.skeleton;
        return {ring.centre, ring.half.x(), s.position[other], s.radius[other]};
    }
    /// How far a ring may lean over a bone, on the inner side of a bend: not quite to its middle where a ring
    /// comes from the other node too, and not to the rings of a round end. Further, both would cross.
    double room_of(std::int32_t p, std::int32_t other, const ConeFrom& bone) const {
        const auto nodes = n_.nodes(p);
        if (n_.path_closed[p] || (other != nodes.front() && other != nodes.back()))
            return to_next_bend * bone.length;
        const int end = other == nodes.front() ? 0 : 1;
        if (n_.path_end[p][end].at_joint()) return to_joint * bone.length;
        return to_round_end * std::clamp(bone.side_end(), least_side * bone.length, bone.length);
    }
    static Vec3 ellipse(const Station& ring, const Vec3& ray) {
        if (ring.half.x() == ring.half.y()) return ring.half.x() * ray;
        const Vec3 form_y = ring.tangent.cross(ring.form_x);
        return ring.half.x() * ray.dot(ring.form_x) * ring.form_x + ring.half.y() * ray.dot(form_y) * form_y;
    }
    /// A tube cut askew at a bend is wider across the bend.
    static Vec3 widened(const Station& ring, const Vec3& v) {
        const double by = ring.bend.norm();
        return by > 0 ? Vec3(v + v.dot(ring.bend) * ring.bend / by) : v;
    }
    /// Corners at the path's corner columns, the columns between them evenly along the sides.
    Vec3 on_outline(const Station& ring, std::int32_t p, std::int32_t k) const {
        const std::int32_t sides = d_.refinement.path_sides[p], first = d_.stations.corner[p];
        const Vec3 form_y = ring.tangent.cross(ring.form_x);
        const auto corner = [&](int c) -> Vec3 {
            const int turned = (c + ring.corner) % 4;
            const double x = turned == 0 || turned == 3 ? 1 : -1, y = turned < 2 ? 1 : -1;
            return x * ring.half.x() * ring.form_x + y * ring.half.y() * form_y;
        };
        const auto columns_after_first = [&](std::int32_t column) {
            return ((column - first) % sides + sides) % sides;
        };
        const std::int32_t at = columns_after_first(k);
        int c = 0;
        while (c < 3 && columns_after_first(corner_column(first, c + 1, sides)) <= at) ++c;
        const std::int32_t begin = columns_after_first(corner_column(first, c, sides));
        const std::int32_t end = c == 3 ? sides : columns_after_first(corner_column(first, c + 1, sides));
        const double share = static_cast<double>(at - begin) / (end - begin);
        return ring.centre + widened(ring, (1 - share) * corner(c) + share * corner((c + 1) % 4));
    }

    void path(std::int32_t p) {
        const Stations& s = d_.stations;
        const std::int32_t sides = d_.refinement.path_sides[p], first = s.first[p], end = s.first[p + 1];
        const double* angle = &s.angle[s.angle_first[p]];
        const double* near = &s.near_uneven[s.angle_first[p]];
        const double* far = &s.far_uneven[s.angle_first[p]];
        for (std::int32_t i = first; i < end; ++i) {
            const Station& ring = s.stations[i];
            const std::uint32_t vertex = first_of_ring(d_, out_, p, i);
            origin(vertex, sides, ring);
            if (ring.shape == RingShape::follow || ring.shape == RingShape::pit) continue;
            ring_vertices(
                i, p, {&out_.mesh.positions[vertex], static_cast<std::size_t>(sides)}, [&](std::size_t k) {
                    return angle[k] + ring.turn + ring.near_share * near[k] + ring.far_share * far[k];
                });
        }
        poles(p);
        if (!d_.surfaces.pits.empty()) place_dent_rings(d_, p, out_);
        if (options_.ideal) pull_in(p);
        follow(p);
    }
    /// Rings on the first bone from a joint that are too wide for its cell.
    void pull_in(std::int32_t p) {
        const Stations& s = d_.stations;
        const auto [near, far] = s.crowded[p];
        if (!near && !far) return;
        const auto nodes = n_.nodes(p), bones = n_.bones(p);
        const std::size_t last = nodes.size() - 1, sides = d_.refinement.path_sides[p];
        const CellRoom a = room_of_end(p, near ? 0 : 1), b = room_of_end(p, far ? 1 : 0);
        for (std::int32_t i = s.first[p]; i < s.first[p + 1]; ++i) {
            const Station& ring = s.stations[i];
            const bool in_a = near && may_be_pulled(ring, bones[0], nodes[1]),
                       in_b = far && may_be_pulled(ring, bones[last - 1], nodes[last - 1]);
            for (std::size_t k = 0; (in_a || in_b) && k < sides; ++k) {
                Vec3f& at = out_.mesh.positions[first_of_ring(d_, out_, p, i) + k];
                const Vec3 v = at.cast<double>();
                at = (in_a && in_b ? Vec3(0.5 * (a.pull_in(b.pull_in(v)) + b.pull_in(a.pull_in(v))))
                      : in_a       ? a.pull_in(v)
                                   : b.pull_in(v))
                         .cast<float>();
            }
        }
    }
    CellRoom room_of_end(std::int32_t p, int end) const {
        const PathEnd& e = n_.path_end[p][end];
        return {d_.skeleton, n_, d_.polyhedra, d_.surfaces, e.joint, e.slot};
    }
    void origin(std::uint32_t vertex, std::int32_t sides, const Station& ring) {
        const std::int32_t node = d_.skeleton.source_node[ring.node],
                           bone = d_.skeleton.source_bone[ring.bone];
        for (std::uint32_t v = vertex; v < vertex + sides; ++v) {
            out_.mesh.vertex_node[v] = node;
            out_.mesh.vertex_bone[v] = bone;
            out_.mesh.vertex_along[v] = ring.along;
        }
    }

    /// Rings between a joint and the first proper one, or the pole: along great circles, out to the joint's
    /// surface.
    void follow(std::int32_t p) {
        const Stations& s = d_.stations;
        const std::int32_t sides = d_.refinement.path_sides[p], first = s.first[p], end = s.first[p + 1];
        std::vector<std::uint32_t> joint_ring;
        for (int side = 0; side < 2; ++side) {
            const PathEnd& e = n_.path_end[p][side];
            if (!e.at_joint() || first == end) continue;
            const std::int32_t step = side == 0 ? 1 : -1;
            const auto follows = [&](std::int32_t i) {
                return i >= first && i < end && s.stations[i].shape == RingShape::follow &&
                       s.stations[i].far == (side == 1);
            };
            std::int32_t i = side == 0 ? first : end - 1, proper = i;
            if (!follows(i)) continue;
            while (follows(proper)) proper += step;
            const bool to_pole = proper < first || proper >= end;
            joint_ring_of_path(d_, p, side, joint_ring);
            for (; i != proper; i += step)
                for (std::int32_t k = 0; k < sides; ++k) {
                    const std::uint32_t target =
                        to_pole ? out_.path_pole[p][1 - side] : first_of_ring(d_, out_, p, proper) + k;
                    set(first_of_ring(d_, out_, p, i) + k,
                        follow_surface(d_, e, position(joint_ring[k]), position(target), s.stations[i].share),
                        s.stations[i].node);
                }
        }
    }
    void poles(std::int32_t p) {
        const auto nodes = n_.nodes(p);
        for (int side = 0; side < 2; ++side) {
            const std::uint32_t pole = out_.path_pole[p][side];
            if (pole == no_vertex) continue;
            const std::int32_t leaf = side == 0 ? nodes.front() : nodes.back();
            const std::int32_t other = side == 0 ? nodes[1] : nodes[nodes.size() - 2];
            const Vec3& at = d_.skeleton.position[leaf];
            const Vec3 outward = (at - d_.skeleton.position[other]).normalized();
            set(pole, pole_of(p, side, leaf, at, outward), leaf);
        }
    }
    Vec3 pole_of(std::int32_t p, int side, std::int32_t leaf, const Vec3& at, const Vec3& outward) const {
        const PathEnd& joint = d_.network.path_end[p][1 - side];
        switch (d_.skeleton.cap[leaf]) {
            case Cap::round:
                return at + d_.skeleton.radius[leaf] * outward;
            case Cap::surface: {
                if (!joint.at_joint()) return at;
                const Vec3& centre = d_.skeleton.position[n_.joint_node[joint.joint]];
                return centre + exit_of_joint(n_, d_.surfaces, joint.joint, centre, outward) * outward;
            }
            case Cap::pit:
                return joint.at_joint() ? bottom_of_dent(d_, joint) : at;
            case Cap::flat:
            case Cap::point:
                break;
        }
        return at;
    }
    void capped() {
        std::int32_t j = 0;
        for (std::size_t i = 0; i < out_.capped.size(); ++i) {
            const std::int32_t c = out_.capped[i];
            while (d_.polyhedra.cell_first[j + 1] <= c) ++j;
            const Vec3& ray = d_.polyhedra.sites[c];
            const std::int32_t node = n_.joint_node[j];
            const Vec3& centre = d_.skeleton.position[node];
            set(out_.capped_pole + static_cast<std::uint32_t>(i),
                centre + exit_of_joint(n_, d_.surfaces, j, centre, ray) * ray, node);
        }
    }
    /// A sphere, an ellipsoid or a box, from the points of a cube.
    void lone() {
        std::uint32_t vertex = out_.lone_vertex;
        for (const std::int32_t node : n_.lone) {
            const Form* form = d_.skeleton.form(node);
            for (const auto& p : lone_sphere_points()) {
                const Vec3 corner(p[0], p[1], p[2]);
                Vec3 v = d_.skeleton.radius[node] * corner.normalized();
                if (form) {
                    const Vec3 local = form->half.cwiseProduct(
                        form->kind == Form::Kind::box ? corner : Vec3(corner.normalized()));
                    v = local.x() * form->x + local.y() * form->y + local.z() * form->z;
                }
                set(vertex++, d_.skeleton.position[node] + v, node);
            }
        }
    }

    const Parts& d_;
    const Network& n_;
    PlaceOptions options_;
    Bridge& out_;
};

}  // namespace

void place(const Parts& parts, const PlaceOptions& options, Bridge& bridge) {
    Placer(parts, options, bridge).run();
}

}  // namespace sinew::sqm
