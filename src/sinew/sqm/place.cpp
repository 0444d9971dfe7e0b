#include "sinew/sqm/place.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sinew/base/portable_math.h"
#include "sinew/sqm/cell_room.h"
#include "sinew/sqm/dents.h"
#include "sinew/sqm/features.h"
#include "sinew/sqm/fit.h"
#include "sinew/sqm/symmetrise.h"

namespace sinew::sqm {
namespace {

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
        for (std::int32_t j = 0; j < n_.joint_count(); ++j) {
            const std::int32_t node = n_.joint_node[j];
            const Vec3& centre = d_.skeleton.position[node];
            for (std::uint32_t v = d_.points.first[j]; v < d_.points.first[j + 1]; ++v) {
                const Vec3& point = d_.points.position[v];
                const Vec3 on_ball = centre + d_.skeleton.radius[node] * (point - centre).normalized();
                set(v, options_.ideal ? point : on_ball, node);
            }
        }
    }

    /// The vertices of a ring that stands by itself; column k is seen at angle(k) from ring.x.
    template <class Angle>
    void ring_vertices(const Station& ring, std::int32_t p, std::span<Vec3f> to, Angle angle) const {
        const Vec3 y = ring.tangent.cross(ring.x);
        const auto put = [&](auto from_ray) {
            for (std::size_t k = 0; k < to.size(); ++k) {
                const auto [sine, cosine] = portable::sine_cosine(angle(k));
                to[k] = from_ray(cosine * ring.x + sine * y).template cast<float>();
            }
        };
        if (ring.shape == RingShape::outline) {
            for (std::size_t k = 0; k < to.size(); ++k)
                to[k] = on_outline(ring, p, static_cast<std::int32_t>(k)).cast<float>();
        } else if (ring.shape == RingShape::node && options_.ideal) {
            const ConeFrom before = cone_from(ring, ring.before), after = cone_from(ring, ring.after);
            const double before_room = room_of(p, ring.before, before),
                         after_room = room_of(p, ring.after, after);
            put([&](const Vec3& ray) -> Vec3 {
                const double exit = std::max(before.exit(ray), after.exit(ray));
                const double most = std::min(within(before_room, ray.dot(before.axis)),
                                             within(after_room, ray.dot(after.axis)));
                return ring.centre + std::min(exit, most) * ray;
            });
        } else {
            put([&](const Vec3& ray) -> Vec3 { return ring.centre + widened(ring, ellipse(ring, ray)); });
        }
    }
    ConeFrom cone_from(const Station& ring, std::int32_t other) const {
        const Plain& s = d_.skeleton;
        return {ring.centre, ring.half.x(), s.position[other], s.radius[other]};
    }
    /// How far a ring may lean over a bone, on the inner side of a bend: not quite to its middle where a ring
    /// comes from the other node too, and not to the rings of a round end. Further, both would cross.
    double room_of(std::int32_t p, std::int32_t other, const ConeFrom& bone) const {
        const auto nodes = n_.nodes(p);
        if (n_.path_closed[p] || (other != nodes.front() && other != nodes.back())) return 0.49 * bone.length;
        const int end = other == nodes.front() ? 0 : 1;
        if (n_.path_end[p][end].at_joint()) return 0.5 * bone.length;
        return 0.9 * std::clamp(bone.side_end(), 0.1 * bone.length, bone.length);
    }
    static double within(double room, double lean) {
        return lean > 0 ? room / lean : std::numeric_limits<double>::infinity();
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

    /// A vertex on the wall of a dent, which is half an ellipsoid: from over it, on the joint's surface,
    /// towards the joint's centre, or straight down where the dent goes past that.
    Vec3 on_pit(const Station& ring, std::int32_t p, const Vec3& rim, double share) const {
        const PathEnd& end = d_.network.path_end[p][ring.far ? 1 : 0];
        const std::int32_t slot = n_.slot_first[end.joint] + end.slot;
        const PitShape& pit = d_.points.pits[d_.points.extra[slot]];
        const Vec3& centre = d_.skeleton.position[n_.joint_node[end.joint]];
        Vec3 over = pit.middle + share * rim;
        for (int i = 0; i < 6; ++i) {  // the surface is nearly flat there: this settles fast
            const Vec3 ray = (over - centre).normalized();
            const Vec3 hit = centre + exit_without_dents(n_, d_.points, end.joint, ray) * ray;
            over += (hit - over).dot(pit.z) * pit.z;
        }
        if (pit.half.z() <
            0.8 * (pit.middle - centre).norm()) {  // as the joint's own points: along their rays
            const double distance = (over - centre).norm();
            const Vec3 ray = (over - centre) / distance;
            return centre + press_dents(d_.points, end.joint, centre, ray, distance) * ray;
        }
        return pressed(end.joint, over - pit.half.z() * std::sqrt(std::max(0.0, 1 - share * share)) * pit.z);
    }
    /// A point on the floor of one dent, once what is left there by others is taken away too.
    Vec3 pressed(std::int32_t joint, const Vec3& point) const {
        const Vec3& centre = d_.skeleton.position[n_.joint_node[joint]];
        const double distance = (point - centre).norm();
        if (distance <= 0) return point;
        const Vec3 ray = (point - centre) / distance;
        return centre + press_dents(d_.points, joint, centre, ray, distance) * ray;
    }

    void path(std::int32_t p) {
        const Stations& s = d_.stations;
        const std::int32_t sides = d_.refinement.path_sides[p], first = s.first[p], end = s.first[p + 1];
        const double* angle = &s.angle[s.angle_first[p]];
        const double* near = &s.near_uneven[s.angle_first[p]];
        const double* far = &s.far_uneven[s.angle_first[p]];
        for (std::int32_t i = first; i < end; ++i) {
            const Station& ring = s.stations[i];
            const std::uint32_t vertex = out_.path_vertex[p] + (i - first) * sides;
            origin(vertex, sides, ring);
            if (ring.shape == RingShape::follow || ring.shape == RingShape::pit) continue;
            ring_vertices(
                ring, p, {&out_.mesh.positions[vertex], static_cast<std::size_t>(sides)}, [&](std::size_t k) {
                    return angle[k] + ring.turn + ring.near_share * near[k] + ring.far_share * far[k];
                });
        }
        poles(p);
        dent(p);
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
                Vec3f& at = out_.mesh.positions[vertex_at(p, i, static_cast<std::int32_t>(k))];
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
        return {d_.skeleton, n_, d_.polyhedra, d_.points, e.joint, e.slot};
    }
    /// The rings of a dent. Where another dent overlaps it they stay within the cell that is theirs, so that
    /// the floor goes on from one to the other without a fold.
    void dent(std::int32_t p) {
        const Stations& s = d_.stations;
        const std::int32_t sides = d_.refinement.path_sides[p], first = s.first[p];
        std::vector<std::uint32_t> joint_ring;
        std::vector<Vec2> cell;
        for (std::int32_t i = first; i < s.first[p + 1]; ++i) {
            const Station& ring = s.stations[i];
            if (ring.shape != RingShape::pit) continue;
            const int end = ring.far ? 1 : 0;
            const PathEnd& e = n_.path_end[p][end];
            if (joint_ring.empty()) joint_ring_of_path(d_, p, end, joint_ring);
            const PitShape& pit = d_.points.pits[d_.points.extra[n_.slot_first[e.joint] + e.slot]];
            const Vec3& centre = d_.skeleton.position[n_.joint_node[e.joint]];
            const Vec3 y = ring.tangent.cross(ring.x);
            cell.clear();  // on a map round the dent's axis
            for (const std::uint32_t v : joint_ring)
                cell.push_back(on_map(d_.points.position[v] - centre, ring.x, y, pit.z));
            const std::vector<double>& uneven = ring.far ? s.far_uneven : s.near_uneven;
            const auto rim_at = [&](std::int32_t k, double follow) {
                const std::size_t i_angle = s.angle_first[p] + k;
                const auto [sine, cosine] =
                    portable::sine_cosine(s.angle[i_angle] + ring.turn + follow * uneven[i_angle]);
                return ellipse(ring, cosine * ring.x + sine * y);
            };
            const auto room_of = [&](const Vec3& rim) {
                return 0.75 * room_along(cell, on_map(pit.middle + rim - centre, ring.x, y, pit.z));
            };
            bool crowded = false;
            for (std::int32_t k = 0; k < sides; ++k) crowded = crowded || room_of(rim_at(k, 0)) < 1;
            for (std::int32_t k = 0; k < sides; ++k) {
                const Vec3 rim = rim_at(k, crowded ? 0.9 * ring.share : 0);
                const double share = ring.share * std::min(1.0, room_of(rim));
                set(vertex_at(p, i, k), on_pit(ring, p, rim, share), ring.node);
            }
        }
    }
    /// Directions round z as points of a plane, as far from its middle as they are from z, in radians.
    static Vec2 on_map(const Vec3& v, const Vec3& x, const Vec3& y, const Vec3& z) {
        const Vec2 flat(v.dot(x), v.dot(y));
        const double across = flat.norm();
        return across > 0 ? Vec2(portable::angle_of(across, v.dot(z)) / across * flat) : Vec2(Vec2::Zero());
    }
    /// How often `to` goes into the way from the middle to the edge of a polygon round it.
    static double room_along(const std::vector<Vec2>& polygon, const Vec2& to) {
        double room = 1e300;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Vec2 &a = polygon[i], edge = polygon[(i + 1) % polygon.size()] - a;
            const double across = to.x() * edge.y() - to.y() * edge.x();
            if (across == 0) continue;
            const double t = (a.x() * edge.y() - a.y() * edge.x()) / across,
                         u = (a.x() * to.y() - a.y() * to.x()) / across;
            if (t > 0 && u >= -1e-9 && u <= 1 + 1e-9) room = std::min(room, t);
        }
        return room;
    }
    std::uint32_t vertex_at(std::int32_t p, std::int32_t i, std::int32_t k) const {
        return out_.path_vertex[p] + (i - d_.stations.first[p]) * d_.refinement.path_sides[p] + k;
    }
    void origin(std::uint32_t vertex, std::int32_t sides, const Station& ring) {
        std::fill_n(&out_.mesh.vertex_node[vertex], sides, d_.skeleton.source_node[ring.node]);
        std::fill_n(&out_.mesh.vertex_bone[vertex], sides, d_.skeleton.source_bone[ring.bone]);
        std::fill_n(&out_.mesh.vertex_along[vertex], sides, ring.along);
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
                    const std::uint32_t target = to_pole ? out_.path_pole[p][1 - side]
                                                         : out_.path_vertex[p] + (proper - first) * sides + k;
                    set(out_.path_vertex[p] + (i - first) * sides + k,
                        between(e.joint, position(joint_ring[k]), position(target), s.stations[i].share),
                        s.stations[i].node);
                }
        }
    }
    Vec3 between(std::int32_t joint, const Vec3& at_joint, const Vec3& on_ring, double share) const {
        const Vec3& centre = d_.skeleton.position[n_.joint_node[joint]];
        const Vec3 a = at_joint - centre, b = on_ring - centre;
        const double la = a.norm(), lb = b.norm();
        const Form* body = d_.points.body[joint];
        const Vec3 u = to_ball_space(body, a / la), v = to_ball_space(body, b / lb);
        const double sine = u.cross(v).norm(), angle = portable::angle_of(sine, u.dot(v));
        if (!(angle > 1e-6 && angle < 3.1)) return at_joint + share * (on_ring - at_joint);
        const Vec3 ray = from_ball_space(body, (portable::sine_cosine((1 - share) * angle).sine * u +
                                                portable::sine_cosine(share * angle).sine * v) /
                                                   sine);
        return centre + exit_of_joint(n_, d_.points, joint, centre, ray) * ray;
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
                return centre + exit_of_joint(n_, d_.points, joint.joint, centre, outward) * outward;
            }
            case Cap::pit: {
                if (!joint.at_joint()) return at;
                const std::int32_t slot = n_.slot_first[joint.joint] + joint.slot;
                const PitShape& pit = d_.points.pits[d_.points.extra[slot]];
                return pressed(joint.joint, pit.middle - pit.half.z() * pit.z);
            }
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
                centre + exit_of_joint(n_, d_.points, j, centre, ray) * ray, node);
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

Result<void> place(const Parts& parts, const Images& images, const PlaceOptions& options, Bridge& bridge) {
    Placer(parts, options, bridge).run();
    add_features(parts, bridge);
    const auto image = vertex_images(parts, images, bridge);
    if (options.limit)
        if (auto fitted = fit_limit(parts, bridge); !fitted) return fitted;
    make_symmetric(images, image, bridge.mesh.positions);
    return {};
}

}  // namespace sinew::sqm
