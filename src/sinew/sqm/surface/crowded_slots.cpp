#include "sinew/sqm/surface/crowded_slots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace sinew::sqm {
namespace {

constexpr std::int32_t leaf_size = 8;
constexpr double unlimited = std::numeric_limits<double>::infinity();
/// What rounding may add to a bound, of it.
constexpr double rounding = 1 + 1e-9;

}  // namespace

CrowdedSlots::CrowdedSlots(std::span<const ConeFrom> cones) : slots_(cones.size()) {
    std::iota(slots_.begin(), slots_.end(), 0);
    Node root;
    root.end = static_cast<std::int32_t>(slots_.size());
    nodes_.push_back(root);
    for (std::size_t i = 0; i < nodes_.size(); ++i) split(static_cast<std::int32_t>(i), cones);
}

void CrowdedSlots::bound(Node& node, std::span<const ConeFrom> cones) const {
    Vec3 sum = Vec3::Zero();
    for (std::int32_t i = node.begin; i < node.end; ++i) sum += cones[slots_[i]].axis;
    node.axis = sum.squaredNorm() > 0 ? Vec3(sum.normalized()) : Vec3(Vec3::UnitX());
    node.limit = unlimited;
    for (std::int32_t i = node.begin; i < node.end; ++i) {
        const ConeFrom& cone = cones[slots_[i]];
        node.spread = std::max(node.spread, (cone.axis - node.axis).norm());
        node.width = std::max({node.width, cone.near, cone.far});
        const bool nest = std::abs(cone.near - cone.far) >= cone.length;
        node.slope = std::min(node.slope, nest ? 0 : cone.sine);
        node.length = std::max({node.length, cone.near, cone.length + cone.far});
    }
}

/// In the middle of the coordinate in which the axes differ most.
void CrowdedSlots::split(std::int32_t at, std::span<const ConeFrom> cones) {
    bound(nodes_[at], cones);
    const std::int32_t begin = nodes_[at].begin, end = nodes_[at].end;
    if (end - begin <= leaf_size) return;
    Vec3 low = Vec3::Ones(), high = -low;
    for (std::int32_t i = begin; i < end; ++i) {
        low = low.cwiseMin(cones[slots_[i]].axis);
        high = high.cwiseMax(cones[slots_[i]].axis);
    }
    int widest = 0;
    (high - low).maxCoeff(&widest);
    const std::int32_t middle = (begin + end) / 2;
    std::nth_element(slots_.begin() + begin, slots_.begin() + middle, slots_.begin() + end,
                     [&](std::int32_t a, std::int32_t b) {
                         const double of_a = cones[a].axis[widest], of_b = cones[b].axis[widest];
                         return of_a != of_b ? of_a < of_b : a < b;
                     });
    nodes_[at].child = static_cast<std::int32_t>(nodes_.size());
    Node child;
    child.begin = begin, child.end = middle;
    nodes_.push_back(child);
    child.begin = middle, child.end = end;
    nodes_.push_back(child);
}

void CrowdedSlots::set_limits(std::span<const double> limits) {
    for (std::size_t i = nodes_.size(); i-- > 0;) {
        Node& node = nodes_[i];
        node.limit =
            node.child < 0 ? unlimited : std::min(nodes_[node.child].limit, nodes_[node.child + 1].limit);
        for (std::int32_t k = node.begin; node.child < 0 && k < node.end; ++k)
            node.limit = std::min(node.limit, limits[slots_[k]]);
    }
}

/// No axis below a node is nearer to the ray.
double CrowdedSlots::chord_to(const Node& node, const Vec3& ray) {
    return std::max(0.0, (ray - node.axis).norm() - node.spread * rounding);
}

/// Looks at the slots below the nodes that are worth more than what is known, the worthiest first. Every split
/// halves a node: there are never more than 64 to come back to.
/// @param known  what the best answer so far is worth
template <class Worth, class Known, class See>
void CrowdedSlots::search(Worth worth, Known known, See see) const {
    struct Open {
        std::int32_t node;
        double worth;
    };
    std::array<Open, 66> open;
    std::size_t count = 0;
    open[count++] = {0, worth(nodes_[0])};
    while (count > 0) {
        const Open next = open[--count];
        if (!(next.worth > known())) continue;
        const Node& node = nodes_[next.node];
        if (node.child < 0) {
            for (std::int32_t i = node.begin; i < node.end; ++i) see(slots_[i]);
            continue;
        }
        Open low{node.child, worth(nodes_[node.child])}, high{node.child + 1, worth(nodes_[node.child + 1])};
        if (low.worth > high.worth) std::swap(low, high);
        open[count++] = low;
        open[count++] = high;
    }
}

double CrowdedSlots::exit(std::span<const ConeFrom> cones, const Vec3& ray) const {
    double distance = 0;
    // A round cone ends behind its far ball, and is inside the cylinder of its widest ball, or, if it is no
    // nest, inside the slanted side that closes least.
    const auto worth = [&](const Node& node) {
        const double chord = chord_to(node, ray), square = chord * chord;
        const double cosine = 1 - 0.5 * square, sine = square < 2 ? chord * std::sqrt(1 - 0.25 * square) : 1;
        double most = std::min(node.length, node.width / sine);
        const double opening = sine * std::sqrt(1 - node.slope * node.slope) + cosine * node.slope;
        if (node.slope > 0 && opening > 0)
            most = std::min(most, cosine > node.slope ? node.width / opening : node.width);
        return most * rounding;
    };
    search(
        worth, [&] { return distance; },
        [&](std::int32_t slot) { distance = std::max(distance, cones[slot].exit(ray)); });
    return distance;
}

double CrowdedSlots::limited(std::span<const ConeFrom> cones, std::span<const double> limits, const Vec3& ray,
                             double distance) const {
    const auto worth = [&](const Node& node) {
        const double chord = chord_to(node, ray), cosine = 1 - 0.5 * chord * chord;
        return cosine > 0 ? -node.limit / (cosine * rounding) : -unlimited;
    };
    search(
        worth, [&] { return -distance; },
        [&](std::int32_t slot) {
            const double along = ray.dot(cones[slot].axis);
            if (along > 0 && distance * along > limits[slot]) distance = limits[slot] / along;
        });
    return distance;
}

double CrowdedSlots::nearest_cosine(std::span<const ConeFrom> cones, std::int32_t slot) const {
    const Vec3& axis = cones[slot].axis;
    double nearest = -1;
    const auto worth = [&](const Node& node) {
        const double chord = chord_to(node, axis);
        return std::min(1 - 0.5 * chord * chord + 1e-12, 1.0);
    };
    search(
        worth, [&] { return nearest; },
        [&](std::int32_t other) {
            if (other != slot) nearest = std::max(nearest, axis.dot(cones[other].axis));
        });
    return nearest;
}

}  // namespace sinew::sqm
