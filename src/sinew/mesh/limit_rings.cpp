#include "sinew/mesh/limit_rings.h"

#include <Eigen/Core>
#include <algorithm>

#include "sinew/mesh/sharpness.h"

namespace sinew {
namespace {

using Row = Eigen::RowVectorXd;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Eigen::Index;

bool fading(float sharpness) { return sharpness > 0 && sharpness < infinite_sharpness; }

constexpr int dart_steps = 48;  // each at least halves what is left

/// A ring in which every point is a row of weights on the points it began with.
class Ring {
  public:
    Ring(std::span<const float> sharpness, bool closed)
        : sharpness_(sharpness.begin(), sharpness.end()),
          faces_(static_cast<Index>(sharpness.size()) - (closed ? 0 : 1)),
          closed_(closed) {
        const Index size = 1 + edges() + faces_;
        const Rows identity = Rows::Identity(size, size);
        vertex_ = identity.row(0);
        edge_ = identity.middleRows(1, edges());
        mean_ = identity.bottomRows(faces_);
    }

    bool fades() const { return std::any_of(sharpness_.begin(), sharpness_.end(), fading); }

    void step() {
        const Rows face = mean_;
        Rows edge(edges(), vertex_.size());
        for (Index i = 0; i < edges(); ++i) edge.row(i) = new_edge_point(i);
        const Row vertex = new_vertex();
        vertex_ = vertex;
        edge_ = edge;
        for (Index i = 0; i < faces_; ++i)
            mean_.row(i) = (vertex_ + edge_.row(i) + face.row(i) + edge_.row((i + 1) % edges())) / 4;
        for (float& s : sharpness_) s = finer_sharpness(s);
    }

    /// The limit of what is only smooth or infinitely sharp by now.
    Row limit() {
        const std::vector<Index> sharp = sharp_edges();
        if (sharp.size() > 2) return vertex_;
        if (sharp.size() == 2) return (4 * vertex_ + edge_.row(sharp[0]) + edge_.row(sharp[1])) / 6;
        if (sharp.size() == 1) {
            for (int i = 0; i < dart_steps; ++i) step();
            return vertex_;
        }
        const SmoothWeights weights(static_cast<double>(edges()));
        return weights.vertex * vertex_ + weights.edge * edge_.colwise().sum() +
               weights.face * mean_.colwise().sum();
    }

  private:
    Index edges() const { return static_cast<Index>(sharpness_.size()); }

    std::vector<Index> sharp_edges() const {
        std::vector<Index> sharp;
        for (Index i = 0; i < edges(); ++i)
            if (sharpness_[static_cast<std::size_t>(i)] > 0) sharp.push_back(i);
        return sharp;
    }

    Row new_edge_point(Index i) const {
        const double share = edge_rule(sharpness_[static_cast<std::size_t>(i)]);
        const Row middle = (vertex_ + edge_.row(i)) / 2;
        if (share == 1) return middle;
        const Row faces = (mean_.row((i + faces_ - 1) % faces_) + mean_.row(i)) / 2;
        return share * middle + (1 - share) * (middle + faces) / 2;
    }

    Row new_vertex() const {
        const std::vector<Index> sharp = sharp_edges();
        std::vector<SharpSpoke> spokes;
        for (const Index i : sharp) spokes.push_back({.sharpness = sharpness_[static_cast<std::size_t>(i)]});
        const VertexRule rule = vertex_rule(spokes, false);
        Row moved = rule.corner * vertex_;
        if (rule.crease > 0)
            moved += rule.crease *
                     (6 * vertex_ + edge_.row(sharp[rule.ends[0]]) + edge_.row(sharp[rule.ends[1]])) / 8;
        if (rule.smooth > 0 && closed_) {
            const auto n = static_cast<double>(edges());
            const Row around = edge_.colwise().sum() + mean_.colwise().sum();
            moved += rule.smooth * ((n - 2) / n * vertex_ + around / (n * n));
        }
        return moved;
    }

    std::vector<float> sharpness_;
    Index faces_;
    bool closed_;
    Row vertex_;
    Rows edge_;
    Rows mean_;  ///< of the corners of each face
};

RingWeights weights_of(const Row& row, std::size_t edges) {
    RingWeights weights{.vertex = row[0], .edges = {}, .faces = {}};
    weights.edges.assign(row.data() + 1, row.data() + 1 + edges);
    weights.faces.assign(row.data() + 1 + edges, row.data() + row.size());
    return weights;
}

RingWeights constant(std::size_t edges, std::size_t faces) {
    return {.vertex = 1, .edges = std::vector<double>(edges, 0), .faces = std::vector<double>(faces, 0)};
}

/// Limit where nothing fades, which needs no subdivision: all but darts.
RingWeights steady_weights(std::span<const float> sharpness, bool closed) {
    const std::size_t n = sharpness.size();
    RingWeights weights = constant(n, closed ? n : n - 1);
    const auto infinite = [](float s) { return s >= infinite_sharpness; };
    const auto count = std::count_if(sharpness.begin(), sharpness.end(), infinite);
    if (count == 2) {
        weights.vertex = 2.0 / 3;
        for (std::size_t i = 0; i < n; ++i) weights.edges[i] = infinite(sharpness[i]) ? 1.0 / 6 : 0;
    } else if (count < 2 && closed) {
        const SmoothWeights smooth(static_cast<double>(n));
        weights.vertex = smooth.vertex;
        std::fill(weights.edges.begin(), weights.edges.end(), smooth.edge);
        std::fill(weights.faces.begin(), weights.faces.end(), smooth.face);
    }
    return weights;
}

}  // namespace

RingWeights limit_weights(std::span<const float> sharpness, bool closed, bool corner) {
    const std::size_t n = sharpness.size();
    if (corner || n < 2) return constant(n, closed || n == 0 ? n : n - 1);
    const auto infinite =
        std::count_if(sharpness.begin(), sharpness.end(), [](float s) { return s >= infinite_sharpness; });
    const bool fades = std::any_of(sharpness.begin(), sharpness.end(), fading);
    if (n > 256 || (!fades && infinite != 1)) return steady_weights(sharpness, closed);
    Ring ring(sharpness, closed);
    while (ring.fades()) ring.step();
    return weights_of(ring.limit(), n);
}

}  // namespace sinew
