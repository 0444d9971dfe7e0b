#include "sinew/sqm/stage_mesh.h"

namespace sinew::sqm {
namespace {

/// Cells round each vertex, counter-clockwise: across an arc that leaves the vertex the cell to the right
/// comes before the one to the left.
class CellsRoundVertices {
  public:
    explicit CellsRoundVertices(const Polyhedra& p) : p_(p), leaving_(p.vertices.size()) {
        for (std::int32_t a = 0; a < std::ssize(p.arcs); ++a) {
            leaving_[p.arcs[a].from].push_back(a);
            leaving_[p.arcs[a].to].push_back(a);
        }
    }
    std::vector<std::uint32_t> round(std::int32_t vertex) const {
        std::vector<std::uint32_t> cells;
        const auto& arcs = leaving_[vertex];
        std::int32_t cell = right_of(arcs[0], vertex);
        for (std::size_t i = 0; i < arcs.size(); ++i) {
            cells.push_back(static_cast<std::uint32_t>(cell));
            for (const std::int32_t a : arcs)
                if (right_of(a, vertex) == cell) {
                    cell = left_of(a, vertex);
                    break;
                }
        }
        return cells;
    }

  private:
    std::int32_t left_of(std::int32_t a, std::int32_t from) const {
        return p_.arcs[a].from == from ? p_.arcs[a].left : p_.arcs[a].right;
    }
    std::int32_t right_of(std::int32_t a, std::int32_t from) const {
        return p_.arcs[a].from == from ? p_.arcs[a].right : p_.arcs[a].left;
    }
    const Polyhedra& p_;
    std::vector<std::vector<std::int32_t>> leaving_;
};

}  // namespace

QuadMesh polyhedra_mesh(const Plain& skeleton, const Network& network, const Polyhedra& p) {
    QuadMesh mesh;
    for (std::int32_t j = 0; j < network.joint_count(); ++j) {
        const std::int32_t node = network.joint_node[j];
        for (std::int32_t c = p.cell_first[j]; c < p.cell_first[j + 1]; ++c) {
            mesh.positions.push_back(
                (skeleton.position[node] + skeleton.radius[node] * p.sites[c]).cast<float>());
            mesh.vertex_node.push_back(skeleton.source_node[node]);
        }
    }
    const CellsRoundVertices cells(p);
    for (std::int32_t v = 0; v < std::ssize(p.vertices); ++v) mesh.add_face(cells.round(v));
    return mesh;
}

QuadMesh refined_mesh(const Plain& skeleton, const Network& network, const Polyhedra& p,
                      const Refinement& refinement, const JointPoints& points) {
    QuadMesh mesh;
    std::vector<std::uint32_t> ring;
    for (std::int32_t j = 0; j < network.joint_count(); ++j) {
        const std::int32_t node = network.joint_node[j];
        const Vec3& centre = skeleton.position[node];
        for (std::uint32_t i = points.first[j]; i < points.first[j + 1]; ++i) {
            const Vec3 ray = (points.position[i] - centre).normalized();
            mesh.positions.push_back((centre + skeleton.radius[node] * ray).cast<float>());
            mesh.vertex_node.push_back(skeleton.source_node[node]);
        }
        for (std::int32_t c = p.cell_first[j]; c < p.cell_first[j + 1]; ++c) {
            ring.clear();
            for_ring(p, refinement, points, j, c, [&](std::uint32_t point) { ring.push_back(point); });
            mesh.add_face(ring);
        }
    }
    return mesh;
}

}  // namespace sinew::sqm
