#include "sinew/sqm/joint_points.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>

namespace sinew::sqm {
namespace {

/// Node beyond a slot's first bone.
std::int32_t next_node(const Network& n, std::int32_t slot) {
    const std::int32_t path_and_end = n.slot_path[slot];
    const auto nodes = n.nodes(path_and_end / 2);
    return path_and_end % 2 == 0 ? nodes[1] : nodes[nodes.size() - 2];
}
bool straight_to_joint(const Network& n, std::int32_t slot) {
    const std::int32_t path = n.slot_path[slot] / 2;
    return n.nodes(path).size() == 2 && n.path_end[path][0].at_joint() && n.path_end[path][1].at_joint();
}

/// How far along its bone a joint may reach: up to where the next joint's share begins.
double reach_limit(const Network& n, const JointPoints& points, std::int32_t slot) {
    if (!straight_to_joint(n, slot)) return std::numeric_limits<double>::infinity();
    const ConeFrom& cone = points.cone[slot];
    return 0.9 * cone.length * cone.near / (cone.near + cone.far);
}

Vec3 point_towards(const Plain& skeleton, const Network& n, const JointPoints& points, std::int32_t joint,
                   const Vec3& ray) {
    double distance = exit_of_joint(n, points, joint, ray);
    for (std::int32_t slot = n.slot_first[joint]; slot < n.slot_first[joint + 1]; ++slot) {
        const double along = ray.dot(points.cone[slot].axis), limit = reach_limit(n, points, slot);
        if (along > 0 && distance * along > limit) distance = limit / along;
    }
    return skeleton.position[n.joint_node[joint]] + distance * ray;
}

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

}  // namespace

double exit_of_joint(const Network& network, const JointPoints& points, std::int32_t joint, const Vec3& ray) {
    double distance = 0;
    for (std::int32_t slot = network.slot_first[joint]; slot < network.slot_first[joint + 1]; ++slot)
        distance = std::max(distance, points.cone[slot].exit(ray));
    return distance;
}

JointPoints make_joint_points(const Plain& skeleton, const Network& n, const Polyhedra& p,
                              const Refinement& r) {
    JointPoints points;
    lay_out(n, p, r, points);
    points.cone.resize(n.slot_path.size());
    tbb::parallel_for(tbb::blocked_range<std::int32_t>(0, n.joint_count(), 64), [&](const auto& range) {
        for (std::int32_t j = range.begin(); j < range.end(); ++j) {
            const std::int32_t node = n.joint_node[j];
            for (std::int32_t slot = n.slot_first[j]; slot < n.slot_first[j + 1]; ++slot) {
                const std::int32_t next = next_node(n, slot);
                points.cone[slot] = {skeleton.position[node], skeleton.radius[node], skeleton.position[next],
                                     skeleton.radius[next]};
            }
            Vec3* at = &points.position[points.first[j]];
            for (std::int32_t v = p.vertex_first[j]; v < p.vertex_first[j + 1]; ++v)
                *at++ = point_towards(skeleton, n, points, j, p.vertices[v]);
            for (std::int32_t a = p.arc_first[j]; a < p.arc_first[j + 1]; ++a)
                for (std::int32_t i = 1; i < r.pieces[a]; ++i)
                    *at++ = point_towards(skeleton, n, points, j,
                                          point_on_arc(p, p.arcs[a], double(i) / r.pieces[a]));
        }
    });
    return points;
}

void append_ring(const Polyhedra& p, const Refinement& r, const JointPoints& points, std::int32_t joint,
                 std::int32_t cell, std::vector<std::uint32_t>& ring) {
    for (const CellSide& side : p.cell(cell)) {
        const CellArc& arc = p.arcs[side.arc];
        const std::int32_t inner = r.pieces[side.arc] - 1;
        ring.push_back(points.first[joint] + (side.reversed ? arc.to : arc.from) - p.vertex_first[joint]);
        for (std::int32_t i = 0; i < inner; ++i)
            ring.push_back(points.arc_first[side.arc] + (side.reversed ? inner - 1 - i : i));
    }
}

}  // namespace sinew::sqm
