#include "sinew/sqm/cells/images.h"

#include <algorithm>
#include <optional>

namespace sinew::sqm {
namespace {

/// How far from the image of a direction, squared, the one may lie that is taken for it. Images differ by the
/// rounding of doubles alone, and directions of one joint are a tenth or so apart: anything between does.
constexpr double same_place = 1e-12;

/// Finds the images one kind after the other; stops at the first thing without one.
class Search {
  public:
    Search(const Plain& skeleton, const Network& network, const Polyhedra& polyhedra)
        : skeleton_(skeleton), network_(network), p_(polyhedra) {
        images_.order = skeleton.symmetry.order;
        images_.generator = skeleton.symmetry.generator;
        images_.reverses = images_.generator.determinant() < 0;
    }
    std::optional<Images> run() {
        if (!joints() || !cells() || !vertices() || !arcs() || !paths()) return std::nullopt;
        return std::move(images_);
    }

  private:
    std::int32_t node_image(std::int32_t node) const { return skeleton_.symmetry.image[node]; }

    bool joints() {
        std::vector<std::int32_t> joint_of(skeleton_.position.size(), -1);
        for (std::int32_t j = 0; j < network_.joint_count(); ++j) joint_of[network_.joint_node[j]] = j;
        for (const std::int32_t node : network_.joint_node) {
            const std::int32_t j = joint_of[node_image(node)];
            if (j < 0) return false;
            images_.joint.push_back(j);
        }
        return true;
    }

    /// Cells by the site that lies where the image of this one is; added ones lie there up to rounding.
    bool cells() { return match(p_.cell_first, p_.sites, images_.cell); }
    bool vertices() { return match(p_.vertex_first, p_.vertices, images_.vertex); }

    bool match(const std::vector<std::int32_t>& first, const std::vector<Vec3>& points,
               std::vector<std::int32_t>& image) const {
        image.assign(points.size(), -1);
        std::vector<bool> taken(points.size(), false);
        for (std::int32_t j = 0; j < network_.joint_count(); ++j) {
            const std::int32_t k = images_.joint[j];
            if (first[j + 1] - first[j] != first[k + 1] - first[k]) return false;
            for (std::int32_t i = first[j]; i < first[j + 1]; ++i) {
                const Vec3 at = images_.generator * points[i];
                std::int32_t best = -1;
                double nearest = same_place;
                for (std::int32_t m = first[k]; m < first[k + 1]; ++m)
                    if (const double d = (points[m] - at).squaredNorm(); d < nearest) nearest = d, best = m;
                if (best < 0 || taken[best]) return false;
                taken[best] = true;
                image[i] = best;
            }
        }
        return true;
    }

    bool arcs() {
        images_.arc.assign(p_.arcs.size(), -1);
        images_.arc_reversed.assign(p_.arcs.size(), 0);
        for (std::int32_t j = 0; j < network_.joint_count(); ++j) {
            const std::int32_t k = images_.joint[j];
            for (std::int32_t a = p_.arc_first[j]; a < p_.arc_first[j + 1]; ++a)
                if (!arc_image(a, p_.arc_first[k], p_.arc_first[k + 1])) return false;
        }
        return true;
    }
    bool arc_image(std::int32_t a, std::int32_t begin, std::int32_t end) {
        const CellArc& arc = p_.arcs[a];
        std::int32_t from = images_.vertex[arc.from], to = images_.vertex[arc.to];
        std::int32_t left = images_.cell[arc.left], right = images_.cell[arc.right];
        if (images_.reverses) std::swap(left, right);
        for (std::int32_t b = begin; b < end; ++b) {
            const CellArc& c = p_.arcs[b];
            const bool same = c.from == from && c.to == to && c.left == left && c.right == right;
            const bool reversed = c.from == to && c.to == from && c.left == right && c.right == left;
            if (!same && !reversed) continue;
            images_.arc[a] = b;
            images_.arc_reversed[a] = !same;
            return true;
        }
        return false;
    }

    bool paths() {
        images_.path.assign(network_.path_count(), -1);
        images_.path_reversed.assign(network_.path_count(), 0);
        // The bone that starts a path, or ends it, tells the path of the image; closed and jointless paths
        // are told by their nodes.
        std::vector<std::int32_t> path_of_node(skeleton_.position.size(), -1);
        for (std::int32_t p = 0; p < network_.path_count(); ++p)
            for (const std::int32_t node : network_.nodes(p)) path_of_node[node] = p;
        for (std::int32_t p = 0; p < network_.path_count(); ++p) {
            if (!(at_joint(p) ? path_by_cell(p) : path_by_nodes(p, path_of_node))) return false;
            if (network_.nodes(p).size() != network_.nodes(images_.path[p]).size()) return false;
        }
        return true;
    }
    bool at_joint(std::int32_t p) const {
        return network_.path_end[p][0].at_joint() || network_.path_end[p][1].at_joint();
    }

    bool path_by_cell(std::int32_t p) {
        const int side = network_.path_end[p][0].at_joint() ? 0 : 1;
        const PathEnd& end = network_.path_end[p][side];
        const std::int32_t cell = images_.cell[p_.cell_first[end.joint] + end.slot];
        const std::int32_t joint = images_.joint[end.joint], slot = cell - p_.cell_first[joint];
        if (slot >= network_.degree(joint)) return false;
        const PathAndEnd& image = network_.slot_path[network_.slot_first[joint] + slot];
        images_.path[p] = image.path;
        images_.path_reversed[p] = image.end != side;
        return true;
    }
    bool path_by_nodes(std::int32_t p, const std::vector<std::int32_t>& path_of_node) {
        const auto nodes = network_.nodes(p);
        const std::int32_t q = path_of_node[node_image(nodes[0])];
        if (q < 0) return false;
        images_.path[p] = q;
        images_.path_reversed[p] =
            !network_.path_closed[p] && network_.nodes(q).front() != node_image(nodes[0]);
        return true;
    }

    const Plain& skeleton_;
    const Network& network_;
    const Polyhedra& p_;
    Images images_;
};

}  // namespace

Images find_images(const Plain& skeleton, const Network& network, const Polyhedra& polyhedra) {
    if (skeleton.symmetry.order < 2) return {};
    return Search(skeleton, network, polyhedra).run().value_or(Images{});
}

}  // namespace sinew::sqm
