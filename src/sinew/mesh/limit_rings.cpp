#include "sinew/mesh/limit_rings.h"

#include <algorithm>

#include "sinew/mesh/sharpness.h"

namespace sinew {
namespace {

using Row = Eigen::RowVectorXd;

constexpr std::size_t most_edges = 256;  // a ring of weights takes the square of it
constexpr int ring_dart_steps = 48;      // each at least halves what is left

bool is_infinite(float sharpness) { return sharpness >= infinite_sharpness; }

std::vector<Eigen::Index> sharp_in_ring(const VertexRing& ring) {
    std::vector<Eigen::Index> sharp;
    for (std::size_t i = 0; i < ring.sharpness.size(); ++i)
        if (ring.sharpness[i] > 0) sharp.push_back(static_cast<Eigen::Index>(i));
    return sharp;
}

Row new_edge_point(const VertexRing& ring, Eigen::Index i) {
    const Eigen::Index faces = ring.means.rows();
    const double share = edge_rule(ring.sharpness[static_cast<std::size_t>(i)]);
    const Row middle = (ring.vertex + ring.edges.row(i)) / 2;
    if (share == 1) return middle;
    const Row beside = (ring.means.row((i + faces - 1) % faces) + ring.means.row(i)) / 2;
    return share * middle + (1 - share) * (middle + beside) / 2;
}

Row new_vertex(const VertexRing& ring) {
    const std::vector<Eigen::Index> sharp = sharp_in_ring(ring);
    std::vector<SharpSpoke> spokes;
    spokes.reserve(sharp.size());
    for (const Eigen::Index i : sharp)
        spokes.push_back({.sharpness = ring.sharpness[static_cast<std::size_t>(i)]});
    const VertexRule rule = vertex_rule(spokes, false);
    Row moved = rule.corner * ring.vertex;
    if (rule.crease > 0) {
        const Row ends = ring.edges.row(sharp[rule.ends[0]]) + ring.edges.row(sharp[rule.ends[1]]);
        moved += rule.crease * (6 * ring.vertex + ends) / 8;
    }
    if (rule.smooth > 0 && ring.closed) {
        const auto n = static_cast<double>(ring.edges.rows());
        const Row around = ring.edges.colwise().sum() + ring.means.colwise().sum();
        moved += rule.smooth * ((n - 2) / n * ring.vertex + around / (n * n));
    }
    return moved;
}

/// A ring in which every point is the row of weights that is 1 for itself.
VertexRing ring_of_weights(std::span<const float> sharpness, bool closed) {
    const auto edges = static_cast<Eigen::Index>(sharpness.size()), faces = edges - (closed ? 0 : 1);
    const VertexRing::Rows identity = VertexRing::Rows::Identity(1 + edges + faces, 1 + edges + faces);
    return {identity.row(0),
            identity.middleRows(1, edges),
            identity.bottomRows(faces),
            {sharpness.begin(), sharpness.end()},
            closed};
}

/// The limit of a ring that no longer fades.
Row limit_of(VertexRing& ring) {
    const std::vector<Eigen::Index> sharp = sharp_in_ring(ring);
    if (sharp.size() > 2) return ring.vertex;
    if (sharp.size() == 2) return (4 * ring.vertex + ring.edges.row(sharp[0]) + ring.edges.row(sharp[1])) / 6;
    if (sharp.size() == 1) {
        for (int i = 0; i < ring_dart_steps; ++i) refine_ring(ring);
        return ring.vertex;
    }
    const SmoothWeights weights(static_cast<double>(ring.edges.rows()));
    return weights.vertex * ring.vertex + weights.edge * ring.edges.colwise().sum() +
           weights.face * ring.means.colwise().sum();
}

RingWeights weights_of(const Row& row, std::size_t edges) {
    RingWeights weights{.vertex = row[0], .edges = {}, .faces = {}};
    weights.edges.assign(row.data() + 1, row.data() + 1 + edges);
    weights.faces.assign(row.data() + 1 + edges, row.data() + row.size());
    return weights;
}

RingWeights staying(std::size_t edges, std::size_t faces) {
    return {.vertex = 1, .edges = std::vector<double>(edges, 0), .faces = std::vector<double>(faces, 0)};
}

/// The limit where nothing fades, which needs no subdivision but for darts, which count as smooth here.
RingWeights steady_weights(std::span<const float> sharpness, bool closed) {
    const std::size_t n = sharpness.size();
    RingWeights weights = staying(n, closed ? n : n - 1);
    const auto count = std::count_if(sharpness.begin(), sharpness.end(), is_infinite);
    if (count == 2) {
        weights.vertex = 2.0 / 3;
        for (std::size_t i = 0; i < n; ++i) weights.edges[i] = is_infinite(sharpness[i]) ? 1.0 / 6 : 0;
    } else if (count < 2 && closed) {
        const SmoothWeights smooth(static_cast<double>(n));
        weights.vertex = smooth.vertex;
        std::fill(weights.edges.begin(), weights.edges.end(), smooth.edge);
        std::fill(weights.faces.begin(), weights.faces.end(), smooth.face);
    }
    return weights;
}

}  // namespace

void refine_ring(VertexRing& ring) {
    const Eigen::Index edges = ring.edges.rows(), faces = ring.means.rows();
    VertexRing::Rows new_edges(edges, ring.edges.cols());
    for (Eigen::Index i = 0; i < edges; ++i) new_edges.row(i) = new_edge_point(ring, i);
    ring.vertex = new_vertex(ring);
    ring.edges = std::move(new_edges);
    for (Eigen::Index i = 0; i < faces; ++i)  // what was the mean of a face is a corner of the new one
        ring.means.row(i) =
            (ring.vertex + ring.edges.row(i) + ring.means.row(i) + ring.edges.row((i + 1) % edges)).eval() /
            4;
    for (float& sharpness : ring.sharpness) sharpness = finer_sharpness(sharpness);
}

bool fades(std::span<const float> sharpness) {
    return std::any_of(sharpness.begin(), sharpness.end(), [](float s) { return s > 0 && !is_infinite(s); });
}

RingWeights limit_weights(std::span<const float> sharpness, bool closed, bool corner) {
    const std::size_t n = sharpness.size();
    if (corner || n < 2) return staying(n, closed || n == 0 ? n : n - 1);
    const bool dart = std::count_if(sharpness.begin(), sharpness.end(), is_infinite) == 1;
    if (n > most_edges || !(dart || fades(sharpness))) return steady_weights(sharpness, closed);
    VertexRing ring = ring_of_weights(sharpness, closed);
    while (fades(ring.sharpness)) refine_ring(ring);
    return weights_of(limit_of(ring), n);
}

}  // namespace sinew
