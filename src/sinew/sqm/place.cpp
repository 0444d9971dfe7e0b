#include "sinew/sqm/place.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>

#include "sinew/mesh/limit.h"
#include "sinew/sqm/symmetrise.h"

namespace sinew::sqm {
namespace {

class Placer {
  public:
    Placer(const Parts& parts, const PlaceOptions& options, Bridge& bridge)
        : d_(parts), n_(parts.network), options_(options), out_(bridge) {}

    void run() {
        QuadMesh& mesh = out_.mesh;
        positions_.resize(mesh.positions.size());
        mesh.vertex_node.resize(positions_.size());
        mesh.vertex_bone.assign(positions_.size(), -1);
        mesh.vertex_along.assign(positions_.size(), 0);
        joints();
        tbb::parallel_for(tbb::blocked_range<std::int32_t>(0, n_.path_count(), 128), [&](const auto& range) {
            for (std::int32_t p = range.begin(); p < range.end(); ++p) path(p);
        });
        capped();
        lone();
    }
    std::vector<Vec3> take_positions() { return std::move(positions_); }

  private:
    void set(std::uint32_t vertex, const Vec3& position, std::int32_t node) {
        positions_[vertex] = position;
        out_.mesh.vertex_node[vertex] = d_.skeleton.source_node[node];
    }

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

    Vec3 on_ring(const Station& ring, double angle) const {
        const Vec3 ray = std::cos(angle) * ring.x + std::sin(angle) * ring.y;
        if (ring.shape == RingShape::circle || !options_.ideal) return ring.centre + ring.radius * ray;
        const auto cone = [&](std::int32_t other) {
            const Plain& s = d_.skeleton;
            return ConeFrom(ring.centre, ring.radius, s.position[other], s.radius[other]);
        };
        return ring.centre + std::max(cone(ring.before).exit(ray), cone(ring.after).exit(ray)) * ray;
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
            for (std::int32_t k = 0; k < sides; ++k) {
                origin(vertex + k, ring);
                if (ring.shape == RingShape::follow) continue;
                const double at = angle[k] + ring.turn + ring.near_share * near[k] + ring.far_share * far[k];
                set(vertex + k, on_ring(ring, at), ring.node);
            }
        }
        follow(p);
        poles(p);
    }
    void origin(std::uint32_t vertex, const Station& ring) {
        out_.mesh.vertex_node[vertex] = d_.skeleton.source_node[ring.node];
        out_.mesh.vertex_bone[vertex] = d_.skeleton.source_bone[ring.bone];
        out_.mesh.vertex_along[vertex] = ring.along;
    }

    /// Rings between a joint and the first proper one: along great circles, out to the joint's round cones.
    void follow(std::int32_t p) {
        const Stations& s = d_.stations;
        const std::int32_t sides = d_.refinement.path_sides[p], first = s.first[p], end = s.first[p + 1];
        std::vector<std::uint32_t> joint_ring;
        for (int side = 0; side < 2; ++side) {
            const PathEnd& e = n_.path_end[p][side];
            if (!e.at_joint() || first == end) continue;
            const auto follows = [&](std::int32_t i) {
                return s.stations[i].shape == RingShape::follow && s.stations[i].far == (side == 1);
            };
            std::int32_t i = side == 0 ? first : end - 1, proper = i;
            if (!follows(i)) continue;
            while (follows(proper)) proper += side == 0 ? 1 : -1;
            joint_ring.clear();
            append_ring(d_.polyhedra, d_.refinement, d_.points, e.joint,
                        d_.polyhedra.cell_first[e.joint] + e.slot, joint_ring);
            if (side == 1) std::reverse(joint_ring.begin(), joint_ring.end());
            const std::int32_t shift = side == 1 ? s.far_shift[p] : 0;
            const std::uint32_t base = out_.path_vertex[p] + (proper - first) * sides;
            for (; i != proper; i += side == 0 ? 1 : -1)
                for (std::int32_t k = 0; k < sides; ++k)
                    set(out_.path_vertex[p] + (i - first) * sides + k,
                        between(e.joint, positions_[joint_ring[(k + shift) % sides]], positions_[base + k],
                                s.stations[i].share),
                        s.stations[i].node);
        }
    }
    Vec3 between(std::int32_t joint, const Vec3& at_joint, const Vec3& on_ring, double share) const {
        const Vec3& centre = d_.skeleton.position[n_.joint_node[joint]];
        const Vec3 a = at_joint - centre, b = on_ring - centre;
        const double la = a.norm(), lb = b.norm();
        const Vec3 u = a / la, v = b / lb;
        const double angle = std::atan2(u.cross(v).norm(), u.dot(v));
        if (angle < 1e-6 || angle > 3.1) return at_joint + share * (on_ring - at_joint);
        const Vec3 ray = (std::sin((1 - share) * angle) * u + std::sin(share * angle) * v) / std::sin(angle);
        return centre + exit_of_joint(n_, d_.points, joint, ray) * ray;
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
            const bool round = d_.skeleton.cap[leaf] == Cap::round;
            set(pole, round ? Vec3(at + d_.skeleton.radius[leaf] * outward) : at, leaf);
        }
    }
    void capped() {
        std::int32_t j = 0;
        for (std::size_t i = 0; i < out_.capped.size(); ++i) {
            const std::int32_t c = out_.capped[i];
            while (d_.polyhedra.cell_first[j + 1] <= c) ++j;
            const Vec3& ray = d_.polyhedra.sites[c];
            const std::int32_t node = n_.joint_node[j];
            set(out_.capped_pole + static_cast<std::uint32_t>(i),
                d_.skeleton.position[node] + exit_of_joint(n_, d_.points, j, ray) * ray, node);
        }
    }
    void lone() {
        std::uint32_t vertex = out_.lone_vertex;
        for (const std::int32_t node : n_.lone)
            for (const auto& p : lone_sphere_points())
                set(vertex++,
                    d_.skeleton.position[node] +
                        d_.skeleton.radius[node] * Vec3(p[0], p[1], p[2]).normalized(),
                    node);
    }

    const Parts& d_;
    const Network& n_;
    PlaceOptions options_;
    Bridge& out_;
    std::vector<Vec3> positions_;
};

/// A smooth ring through the points of a circle runs inside it between them; this much further out it is as
/// far outside.
void widen_rings(const Parts& parts, const Bridge& bridge, std::span<Vec3> targets) {
    const Stations& s = parts.stations;
    for (std::int32_t p = 0; p < parts.network.path_count(); ++p) {
        const std::int32_t sides = parts.refinement.path_sides[p];
        const double factor = ring_fit_radius(sides);
        for (std::int32_t i = s.first[p]; i < s.first[p + 1]; ++i) {
            Vec3* ring = &targets[bridge.path_vertex[p] + (i - s.first[p]) * sides];
            const Station& station = s.stations[i];
            if (station.shape == RingShape::follow) continue;
            for (std::int32_t k = 0; k < sides; ++k)
                ring[k] = station.centre + factor * (ring[k] - station.centre);
        }
    }
}

void store(const std::vector<Vec3>& positions, QuadMesh& mesh) {
    for (std::size_t v = 0; v < positions.size(); ++v) mesh.positions[v] = positions[v].cast<float>();
}

Result<std::vector<Vec3>> fit_limit(const Parts& parts, Bridge& bridge, std::vector<Vec3> targets) {
    store(targets, bridge.mesh);  // the stencils are refused for a mesh that is not finite
    const auto stencils = build_limit_stencils(bridge.mesh);
    if (!stencils) return fail(stencils.error());
    widen_rings(parts, bridge, targets);
    std::vector<Vec3> control = targets;
    fit_to_limit(*stencils, targets, control);
    return control;
}

}  // namespace

Result<void> place(const Parts& parts, const Images& images, const PlaceOptions& options, Bridge& bridge) {
    Placer placer(parts, options, bridge);
    placer.run();
    std::vector<Vec3> positions = placer.take_positions();
    const auto image = vertex_images(parts, images, bridge, positions);
    if (options.limit) {
        auto control = fit_limit(parts, bridge, std::move(positions));
        if (!control) return fail(control.error());
        positions = std::move(*control);
    }
    make_symmetric(images, image, positions);
    store(positions, bridge.mesh);
    return {};
}

}  // namespace sinew::sqm
