#include "sinew/mesh/deviation.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sinew/mesh/box_tree.h"

namespace sinew {
namespace {

using Index = std::uint32_t;
constexpr double infinity = std::numeric_limits<double>::infinity();

struct BoneCone {
    Vec3 from;
    ConeFrom shape;
};

struct Near {
    double distance = infinity;
    double along = 0;  ///< of the foot on the axis, from the near end
    Index cone = 0;
};

Near distance_to(const BoneCone& cone, const Vec3& point, Index index) {
    const Vec3 seen = point - cone.from;
    return {cone.shape.distance(seen), seen.dot(cone.shape.axis), index};
}

/// A box in floats that holds the axis.
Box axis_box(const BoneCone& c) {
    const Vec3 to = c.from + c.shape.length * c.shape.axis;
    Box box;
    for (const Vec3& end : {c.from, to})
        for (int k = 0; k < 3; ++k) {
            const float nearest = static_cast<float>(end[k]);
            box.low[k] =
                std::min(box.low[k], std::nextafter(nearest, -std::numeric_limits<float>::infinity()));
            box.high[k] =
                std::max(box.high[k], std::nextafter(nearest, std::numeric_limits<float>::infinity()));
        }
    return box;
}

/// The cones in the tree's order, and for every node of the tree the largest radius below it. No point is
/// closer to a cone than to its axis, less the largest radius on it.
class ConeTree {
  public:
    explicit ConeTree(const RoundCones& cones) {
        std::vector<Box> boxes(cones.size());
        for (std::size_t i = 0; i < cones.size(); ++i) boxes[i] = axis_box({cones.from[i], cones.cones[i]});
        tree_ = build_box_tree(boxes);
        for (const Index i : tree_.items) cones_.push_back({cones.from[i], cones.cones[i]});
        radii_.resize(tree_.levels.size());
        for (const BoneCone& c : cones_) radii_[0].push_back(std::max(c.shape.near, c.shape.far));
        for (std::size_t level = 1; level < radii_.size(); ++level)
            for (std::size_t i = 0; i < tree_.levels[level].size(); ++i)
                radii_[level].push_back(
                    *std::max_element(radii_[level - 1].begin() + std::ptrdiff_t(tree_.first_child(i)),
                                      radii_[level - 1].begin() + std::ptrdiff_t(tree_.end_child(level, i))));
    }

    bool empty() const { return cones_.empty(); }
    double largest_radius() const { return radii_.back()[0]; }

    /// @param guess  any cone, best one that is near: it bounds the search from the start
    Near nearest(const Vec3& point, Index guess) const {
        Near best = distance_to(cones_[guess], point, guess);
        search(point, tree_.levels.size() - 1, 0, best);
        return best;
    }
    double radius_at(const Near& near) const {
        const ConeFrom& c = cones_[near.cone].shape;
        const double share = c.length > 0 ? std::clamp(near.along / c.length, 0.0, 1.0) : 0;
        return std::max(c.near + share * (c.far - c.near), 1e-3 * largest_radius());
    }

  private:
    double least_distance(const Vec3& point, std::size_t level, std::size_t node) const {
        const Box& box = tree_.levels[level][node];
        const Vec3 outside =
            (box.low.cast<double>() - point).cwiseMax(point - box.high.cast<double>()).cwiseMax(0.0);
        return outside.norm() - radii_[level][node];
    }

    void search(const Vec3& point, std::size_t level, std::size_t node, Near& best) const {
        if (level == 0) {
            if (const Near here = distance_to(cones_[node], point, static_cast<Index>(node));
                here.distance < best.distance)
                best = here;
            return;
        }
        std::pair<double, std::size_t> children[BoxTree::width];
        std::size_t count = 0;
        for (std::size_t child = tree_.first_child(node); child < tree_.end_child(level, node); ++child)
            children[count++] = {least_distance(point, level - 1, child), child};
        std::sort(children, children + count);
        for (std::size_t i = 0; i < count && children[i].first < best.distance; ++i)
            search(point, level - 1, children[i].second, best);
    }

    BoxTree tree_;
    std::vector<BoneCone> cones_;
    std::vector<std::vector<double>> radii_;
};

}  // namespace

Distances signed_distances(std::span<const Vec3f> points, const RoundCones& cones) {
    const ConeTree tree(cones);
    Distances result{std::vector<double>(points.size(), infinity), std::vector<double>(points.size(), 1)};
    if (tree.empty()) return result;
    // Neighbours in the mesh have neighbouring cones: each search starts from the last one's. Pieces of a
    // fixed size, so that ties do not depend on the threads.
    const std::size_t piece = 1024;
    tbb::parallel_for(std::size_t{0}, (points.size() + piece - 1) / piece, [&](std::size_t p) {
        Near near;
        for (std::size_t i = p * piece; i < std::min(points.size(), (p + 1) * piece); ++i) {
            near = tree.nearest(points[i].cast<double>(), near.cone);
            result.distance[i] = near.distance;
            result.radius[i] = tree.radius_at(near);
        }
    });
    return result;
}

Deviation measure_deviation(const QuadMesh& mesh, const RoundCones& cones) {
    std::vector<char> used(mesh.vertex_count(), 0);
    for (const Index v : mesh.corners) used[v] = mesh.positions[v].allFinite();
    const Distances distances = signed_distances(mesh.positions, cones);
    Deviation result;
    std::vector<double> shares;
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
        if (!used[v]) continue;
        const double share = distances.distance[v] / distances.radius[v];
        result.mean += share;
        result.mean_abs += std::abs(share);
        if (shares.empty() || std::abs(share) > result.max_abs) result.worst = v;
        result.max_abs = std::max(result.max_abs, std::abs(share));
        shares.push_back(std::abs(share));
    }
    if (shares.empty()) return result;
    result.vertices = std::ssize(shares);
    result.mean /= double(shares.size());
    result.mean_abs /= double(shares.size());
    const double rank = 0.95 * double(shares.size() - 1);
    const auto below = shares.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(shares.begin(), below, shares.end());
    const double next = below + 1 < shares.end() ? *std::min_element(below + 1, shares.end()) : *below;
    result.p95_abs = *below + (rank - std::floor(rank)) * (next - *below);
    return result;
}

}  // namespace sinew
