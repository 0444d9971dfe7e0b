#include "sinew/io/swc_soma.h"

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

constexpr std::int64_t soma = 1;

using Children = std::vector<std::vector<std::int32_t>>;

/// Soma samples below each soma sample.
Children soma_children(const std::vector<SwcSample>& samples) {
    Children children(samples.size());
    for (std::int32_t i = 0; i < std::ssize(samples); ++i) {
        const std::int32_t parent = samples[i].parent;
        if (samples[i].type == soma && parent >= 0 && samples[parent].type == soma)
            children[parent].push_back(i);
    }
    return children;
}

bool is_three_point(const std::vector<SwcSample>& samples, const Children& children, std::int32_t root) {
    if (children[root].size() != 2) return false;
    const SwcSample& middle = samples[root];
    const double tolerance = 0.01 * middle.radius;
    for (std::int32_t child : children[root]) {
        if (!children[child].empty()) return false;
        const bool has_radius = samples[child].radius > 0;  // otherwise repair would give it the root's
        if (has_radius && std::abs(samples[child].radius - middle.radius) > tolerance) return false;
        if (std::abs((samples[child].position - middle.position).norm() - middle.radius) > tolerance)
            return false;
    }
    const Vec3 between = (samples[children[root][0]].position + samples[children[root][1]].position) / 2;
    return middle.radius > 0 && (between - middle.position).norm() <= tolerance;
}

/// The chain of soma samples from the root; empty where it forks.
std::vector<std::int32_t> chain_from(const Children& children, std::int32_t root) {
    std::vector<std::int32_t> chain{root};
    while (children[chain.back()].size() == 1) chain.push_back(children[chain.back()][0]);
    if (!children[chain.back()].empty()) chain.clear();
    return chain;
}

/// The sphere that a chain goes round, as a sample's position and radius.
bool contour_sphere(const std::vector<SwcSample>& samples, const std::vector<std::int32_t>& chain,
                    Vec3& centre, double& radius) {
    if (chain.size() < 4) return false;
    double longest_step = 0, largest_radius = 0;
    centre.setZero();
    for (std::size_t k = 0; k < chain.size(); ++k) {
        const SwcSample& sample = samples[chain[k]];
        centre += sample.position / static_cast<double>(chain.size());
        largest_radius = std::max(largest_radius, sample.radius);
        if (k > 0)
            longest_step = std::max(longest_step, (sample.position - samples[chain[k - 1]].position).norm());
    }
    radius = 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::int32_t i : chain) {
        const double distance = (samples[i].position - centre).norm();
        radius += distance / static_cast<double>(chain.size());
        nearest = std::min(nearest, distance);
    }
    const double gap = (samples[chain.back()].position - samples[chain.front()].position).norm();
    // A straight chain has samples near its middle, and one that doubles back too.
    return gap <= 2 * longest_step && radius > 2 * largest_radius && nearest > 0.25 * radius;
}

}  // namespace

std::vector<char> fold_somata(std::vector<SwcSample>& samples, Remarks& remarks) {
    const Children children = soma_children(samples);
    std::vector<std::int32_t> into(samples.size(), -1);
    for (std::int32_t root = 0; root < std::ssize(samples); ++root) {
        if (samples[root].type != soma || samples[root].parent >= 0) continue;
        if (is_three_point(samples, children, root)) {
            for (std::int32_t child : children[root]) into[child] = root;
            continue;
        }
        const std::vector<std::int32_t> chain = chain_from(children, root);
        Vec3 centre;
        double radius = 0;
        if (!contour_sphere(samples, chain, centre, radius)) continue;
        samples[root].position = centre;
        samples[root].radius = radius;
        for (std::int32_t i : chain)
            if (i != root) into[i] = root;
        remarks.note("soma", "drawn as a contour: now a sphere", samples[root].id, samples[root].line);
    }
    std::vector<char> gone(samples.size(), 0);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        gone[i] = into[i] >= 0;
        if (samples[i].parent >= 0 && into[samples[i].parent] >= 0)
            samples[i].parent = into[samples[i].parent];
    }
    return gone;
}

}  // namespace sinew
