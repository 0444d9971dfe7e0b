#include <algorithm>
#include <numeric>

#include "sinew/extend/extend.h"

namespace sinew {
namespace {

// Of the model's extent: how far a node may be from the image that it was made to be, after a turn by sine
// and cosine.
constexpr double rounding = 1e-9;

/// Plain nodes by the document's node that they came from.
class BySource {
  public:
    explicit BySource(const std::vector<std::int32_t>& source) : order_(source.size()), source_(source) {
        std::iota(order_.begin(), order_.end(), 0);
        std::stable_sort(order_.begin(), order_.end(), [&](auto a, auto b) { return source[a] < source[b]; });
    }
    /// The one of a source's nodes that is nearest to a place.
    std::int32_t nearest(const Plain& s, std::int32_t source, const Vec3& place) const {
        auto at = std::lower_bound(order_.begin(), order_.end(), source,
                                   [&](auto i, auto v) { return source_[i] < v; });
        std::int32_t best = -1;
        for (; at != order_.end() && source_[*at] == source; ++at)
            if (best < 0 ||
                (s.position[*at] - place).squaredNorm() < (s.position[best] - place).squaredNorm())
                best = *at;
        return best;
    }

  private:
    std::vector<std::int32_t> order_;
    const std::vector<std::int32_t>& source_;
};

}  // namespace

Automorphism carry_symmetry(const Plain& s, const Mat3& generator, std::int32_t order,
                            std::span<const std::int32_t> image) {
    if (order < 2) return {};
    Automorphism result{generator, order, {}};
    const BySource nodes(s.source_node);
    double extent = 0;
    for (const Vec3& p : s.position) extent = std::max(extent, p.cwiseAbs().maxCoeff());
    std::vector<std::uint8_t> taken(s.position.size(), 0);
    for (std::int32_t i = 0; i < s.node_count(); ++i) {
        const Vec3 place = generator * s.position[i];
        const std::int32_t j = nodes.nearest(s, image[s.source_node[i]], place);
        if (j < 0 || taken[j] || (s.position[j] - place).norm() > rounding * extent || s.cap[i] != s.cap[j])
            return {};
        taken[j] = 1;
        result.image.push_back(j);
    }
    return bones_follow(s.bones, result.image) ? result : Automorphism{};
}

}  // namespace sinew
