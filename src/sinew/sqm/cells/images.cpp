#include "sinew/sqm/cells/images.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace sinew::sqm {
namespace {

/// How far from the image of a direction, squared, the one may lie that is taken for it. Images differ by the
/// rounding of doubles alone, and directions of one joint are a tenth or so apart: anything between does.
constexpr double same_place = 1e-12;

/// Some of the points of one joint, in the order of their height in a direction that nothing is drawn along.
class PlacesByHeight {
  public:
    PlacesByHeight(const std::vector<Vec3>& points, std::int32_t begin, std::int32_t end) {
        for (std::int32_t m = begin; m < end; ++m) places_.emplace_back(height(points[m]), m);
        std::sort(places_.begin(), places_.end());
    }
    /// visit(index) for all that may be in the same place.
    template <class Visit>
    void for_near(const Vec3& place, Visit visit) const {
        const double reach = 2 * std::sqrt(same_place), low = height(place) - reach;
        auto at = std::lower_bound(places_.begin(), places_.end(), std::pair(low, std::int32_t{-1}));
        for (; at != places_.end() && at->first <= low + 2 * reach; ++at) visit(at->second);
    }

  private:
    static double height(const Vec3& p) { return Vec3(0.5377, 0.8339, 0.1246).dot(p); }
    std::vector<std::pair<double, std::int32_t>> places_;
};

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
            const PlacesByHeight places(points, first[k], first[k + 1]);
            for (std::int32_t i = first[j]; i < first[j + 1]; ++i) {
                const Vec3 at = images_.generator * points[i];
                std::int32_t best = -1;
                double nearest = same_place;
                places.for_near(at, [&](std::int32_t m) {
                    const double d = (points[m] - at).squaredNorm();
                    if (d < nearest || (d == nearest && m < best)) nearest = d, best = m;
                });
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
            by_ends_.clear();
            for (std::int32_t b = p_.arc_first[k]; b < p_.arc_first[k + 1]; ++b)
                by_ends_.push_back(ends_and(p_.arcs[b].from, p_.arcs[b].to, b));
            std::sort(by_ends_.begin(), by_ends_.end());
            for (std::int32_t a = p_.arc_first[j]; a < p_.arc_first[j + 1]; ++a)
                if (!arc_image(a)) return false;
        }
        return true;
    }
    /// An arc with its two ends, the lower one first, for arcs to be found by them.
    using EndsAnd = std::array<std::int32_t, 3>;
    static EndsAnd ends_and(std::int32_t from, std::int32_t to, std::int32_t arc) {
        return {std::min(from, to), std::max(from, to), arc};
    }
    bool arc_image(std::int32_t a) {
        const CellArc& arc = p_.arcs[a];
        std::int32_t from = images_.vertex[arc.from], to = images_.vertex[arc.to];
        std::int32_t left = images_.cell[arc.left], right = images_.cell[arc.right];
        if (images_.reverses) std::swap(left, right);
        const EndsAnd wanted = ends_and(from, to, 0);
        for (auto at = std::lower_bound(by_ends_.begin(), by_ends_.end(), wanted);
             at != by_ends_.end() && (*at)[0] == wanted[0] && (*at)[1] == wanted[1]; ++at) {
            const std::int32_t b = (*at)[2];
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
    std::vector<EndsAnd> by_ends_;  // the arcs of the joint that images are looked for at
    Images images_;
};

}  // namespace

Images find_images(const Plain& skeleton, const Network& network, const Polyhedra& polyhedra) {
    if (skeleton.symmetry.order < 2) return {};
    return Search(skeleton, network, polyhedra).run().value_or(Images{});
}

}  // namespace sinew::sqm
