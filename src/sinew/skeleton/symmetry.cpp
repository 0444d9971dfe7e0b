#include "sinew/skeleton/symmetry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "sinew/skeleton/frames.h"
#include "sinew/skeleton/graph.h"
#include "sinew/skeleton/rewire.h"
#include "sinew/skeleton/symmetric_frame.h"

namespace sinew {
namespace {

constexpr double tolerance = 1e-5;  // of the model's size: about the digits that a person types

/// Cosine and sine of part / whole of an eighth of a turn, part in [0, whole], by additions and
/// multiplications only, which give the same digits on every machine.
std::pair<double, double> cosine_sine(std::int64_t part, std::int64_t whole) {
    if (part == whole) return {std::numbers::sqrt2 / 2, std::numbers::sqrt2 / 2};
    const double x = std::numbers::pi / 4 * static_cast<double>(part) / static_cast<double>(whole),
                 xx = x * x;
    double cosine = 1, sine = 1;  // their series, from the far end
    for (int k = 18; k > 0; k -= 2) {
        cosine = 1 - xx / ((k - 1) * k) * cosine;
        sine = 1 - xx / (k * (k + 1)) * sine;
    }
    return {cosine, x * sine};
}

/// Of part / whole of a full turn. Reduced to an eighth of it, so that equal and opposite values have equal
/// digits.
std::pair<double, double> cosine_sine_of_turn(std::int64_t part, std::int64_t whole) {
    const std::int64_t eighth = 8 * part / whole, rest = 8 * part % whole;
    auto [cosine, sine] = eighth % 2 == 0 ? cosine_sine(rest, whole) : cosine_sine(whole - rest, whole);
    if (eighth % 2 == 1) std::swap(cosine, sine);
    for (std::int64_t quarter = eighth / 2 % 4; quarter > 0; --quarter) cosine = -std::exchange(sine, cosine);
    return {cosine + 0.0, sine + 0.0};  // no negative zeros
}

int order_of(const Symmetry& symmetry) {
    switch (symmetry.kind) {
        case Symmetry::Kind::mirror:
            return 2;
        case Symmetry::Kind::radial:
            return symmetry.count;
        default:
            return 1;
    }
}

/// What of a position changes from image to image: the distance from the plane or the axis, as coordinates.
Vec3 off_symmetry(const Symmetry& symmetry, Vec3 position) {
    const double along = std::exchange(position[symmetry.axis], 0);
    return symmetry.kind == Symmetry::Kind::mirror ? Vec3(along * Vec3::Unit(symmetry.axis)) : position;
}

double size_of(const Document& document) {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    double off = 0;
    for (const Node& node : document.nodes) {
        const Vec3 away = off_symmetry(document.symmetry, node.position);
        low = low.cwiseMin(node.position - away);
        high = high.cwiseMax(node.position - away);
        off = std::max(off, 2 * away.norm());
    }
    return document.nodes.empty() ? 0 : Vec2((high - low).norm(), off).norm();
}

/// Finds nodes by their place, through a grid of sorted cells.
class Places {
  public:
    Places(const Document& document, double reach) : nodes_(document.nodes), reach_(reach) {
        for (std::int32_t i = 0; i < std::ssize(nodes_); ++i)
            cells_.emplace_back(cell(nodes_[i].position), i);
        std::ranges::sort(cells_);
    }
    /// The first node there that `wanted` accepts; -1 if there is none.
    template <class Wanted>
    std::int32_t find(const Vec3& place, Wanted&& wanted) const {
        std::int32_t found = -1;
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 step(corner & 1 ? reach_ : -reach_, corner & 2 ? reach_ : -reach_,
                            corner & 4 ? reach_ : -reach_);
            auto at = std::ranges::lower_bound(cells_, std::pair(cell(place + step), std::int32_t{0}));
            for (; at != cells_.end() && at->first == cell(place + step); ++at)
                if ((nodes_[at->second].position - place).norm() <= reach_ && wanted(at->second) &&
                    (found < 0 || at->second < found))
                    found = at->second;
        }
        return found;
    }

  private:
    using Cell = std::array<double, 3>;
    Cell cell(const Vec3& p) const {
        const Vec3 scaled = p / (4 * reach_);
        return {std::floor(scaled.x()), std::floor(scaled.y()), std::floor(scaled.z())};
    }
    const std::vector<Node>& nodes_;
    double reach_;
    std::vector<std::pair<Cell, std::int32_t>> cells_;
};

class Expansion {
  public:
    explicit Expansion(const Document& drawn) : drawn_(drawn), order_(order_of(drawn.symmetry)) {
        out_.document = drawn;
        out_.document.symmetry = {};
        out_.order = order_;
        for (int k = 0; k < order_; ++k) transforms_.push_back(symmetry_transform(drawn.symmetry, k));
        if (order_ > 1) out_.generator = transforms_[1];
        const std::size_t count = drawn.nodes.size();
        source_.resize(count);
        std::iota(source_.begin(), source_.end(), 0);
        shift_.assign(count, 0);
        fixed_.assign(count, order_ == 1);
    }

    ExpandedSymmetry run() {
        if (order_ > 1) {
            find_orbits();
            make_images();
            make_bones();
            round_off_inner_tips(out_.document);
            turn_nodes();
        } else {
            out_.source = out_.image = source_;
            out_.power = shift_;
        }
        return std::move(out_);
    }

  private:
    std::int32_t count() const { return static_cast<std::int32_t>(drawn_.nodes.size()); }
    std::vector<Node>& nodes() { return out_.document.nodes; }

    /// Which drawn nodes stay where they are, and which ones are images of others.
    void find_orbits() {
        const double reach = tolerance * size_of(drawn_);
        for (std::int32_t d = 0; d < count(); ++d) {
            const Vec3 off = off_symmetry(drawn_.symmetry, drawn_.nodes[d].position);
            fixed_[d] = off.norm() <= reach;
            if (!fixed_[d]) continue;
            Vec3& position = nodes()[d].position;
            for (int axis = 0; axis < 3; ++axis)
                if ((axis == drawn_.symmetry.axis) == (drawn_.symmetry.kind == Symmetry::Kind::mirror))
                    position[axis] = 0;
        }
        if (!(reach > 0)) return;  // all of them are fixed
        const Places places(drawn_, reach);
        for (std::int32_t d = 0; d < count(); ++d) {
            if (fixed_[d] || source_[d] != d) continue;
            for (int k = 1; k < order_; ++k) {
                const std::int32_t twin =
                    places.find(transforms_[k] * drawn_.nodes[d].position,
                                [&](std::int32_t e) { return e > d && !fixed_[e] && source_[e] == e; });
                if (twin < 0) continue;
                source_[twin] = d;
                shift_[twin] = k;
            }
        }
    }

    void make_images() {
        const std::size_t slots = static_cast<std::size_t>(count()) * order_;
        at_.assign(slots, -1);
        for (std::int32_t d = 0; d < count(); ++d) at_[slot(source_[d], shift_[d])] = d;
        FreshIds ids(drawn_);
        for (int k = 1; k < order_; ++k)
            for (std::int32_t d = 0; d < count(); ++d) {
                if (fixed_[d] || source_[d] != d) continue;
                std::int32_t& index = at_[slot(d, k)];
                if (index < 0) {
                    index = append_copy(out_.document, d, ids.next());
                } else {
                    const std::int64_t id = std::exchange(nodes()[index], nodes()[d]).id;
                    nodes()[index].id = id;
                }
                nodes()[index].position = transforms_[k] * nodes()[d].position;
            }
        out_.source.resize(nodes().size());
        out_.power.resize(nodes().size());
        out_.image.resize(nodes().size());
        for (std::int32_t d = 0; d < count(); ++d)
            for (int k = 0; k < (fixed_[d] ? 1 : order_) && source_[d] == d; ++k) {
                const std::int32_t node = image_of(d, k);
                out_.source[node] = d;
                out_.power[node] = k;
                out_.image[node] = image_of(d, k + 1);
            }
    }

    std::size_t slot(std::int32_t source, int power) const {
        return static_cast<std::size_t>(source) * order_ + power;
    }
    /// The node at the k-th image of a drawn one.
    std::int32_t image_of(std::int32_t drawn, int k) const {
        return fixed_[drawn] ? drawn : at_[slot(source_[drawn], (shift_[drawn] + k) % order_)];
    }

    /// The drawn bones before their images, so that those stay as they are.
    void make_bones() {
        std::vector<Bone> tree, bones, links;
        for (std::int32_t d = 0; d < count(); ++d)
            if (drawn_.nodes[d].parent >= 0) tree.push_back({drawn_.nodes[d].parent, d});
        for (int k = 0; k < order_; ++k) {
            for (const auto& [a, b] : tree) bones.push_back({image_of(a, k), image_of(b, k)});
            for (const auto& [a, b] : drawn_.links) links.push_back({image_of(a, k), image_of(b, k)});
        }
        set_bones(out_.document, bones, links);
    }

    /// Nodes that are their own images first, so that their shapes are too; then images like their sources.
    void turn_nodes() {
        const std::vector<Bone> bones = bones_of(out_.document);
        const Adjacency around = adjacency(static_cast<std::int32_t>(nodes().size()), bones);
        for (std::int32_t i = 0; i < std::ssize(nodes()); ++i) {
            if (out_.image[i] != i || !has_axes(out_.document, bones, around, i)) continue;
            const Mat3 drawn = local_frame(out_.document, bones, around, i);
            const bool upright = !takes_rotation(nodes()[i], around.degree(i));
            const Mat3 frame =
                symmetric_frame(drawn, extents_of(nodes()[i], around.degree(i)), drawn_.symmetry, upright);
            if (frame != drawn) turn_to(out_.document, bones, around, i, frame, nodes()[i].roll);
        }
        for (std::int32_t i = 0; i < std::ssize(nodes()); ++i) {
            if (out_.power[i] == 0 || !has_axes(out_.document, bones, around, i)) continue;
            const Mat3& transform = transforms_[out_.power[i]];
            Mat3 frame = transform * local_frame(out_.document, bones, around, out_.source[i]);
            if (transform.determinant() < 0) frame.col(0) = -frame.col(0);  // the shapes are symmetric in x
            turn_to(out_.document, bones, around, i, frame, nodes()[out_.source[i]].roll);
        }
    }
    /// Along the axes of its frame; a section has none along z.
    static Vec3 extents_of(const Node& node, std::int32_t degree) {
        if (node.type == NodeType::cube) return node.size.value_or(Vec3::Ones());
        const bool solid = node.type == NodeType::ball || degree == 0;
        const bool plain = node.section == Section::round && node.scale[0] == node.scale[1];
        return {node.scale[0], node.scale[1], solid ? node.scale[2] : plain ? node.scale[0] : 0};
    }

    const Document& drawn_;
    int order_;
    std::vector<Mat3> transforms_;
    ExpandedSymmetry out_;
    std::vector<std::int32_t> source_;  ///< drawn node -> the drawn node that it is an image of
    std::vector<std::int32_t> shift_;   ///< and which one
    std::vector<char> fixed_;
    std::vector<std::int32_t> at_;  ///< node at each image of each source
};

}  // namespace

Mat3 symmetry_transform(const Symmetry& symmetry, int image) {
    Mat3 transform = Mat3::Identity();
    const int order = order_of(symmetry), power = ((image % order) + order) % order;
    if (power == 0) return transform;
    if (symmetry.kind == Symmetry::Kind::mirror) {
        transform(symmetry.axis, symmetry.axis) = -1;
        return transform;
    }
    const auto [cosine, sine] = cosine_sine_of_turn(power, order);
    const int x = (symmetry.axis + 1) % 3, y = (symmetry.axis + 2) % 3;
    transform(x, x) = transform(y, y) = cosine;
    transform(y, x) = sine;
    transform(x, y) = -sine;
    return transform;
}

ExpandedSymmetry expand_symmetry(const Document& document) { return Expansion(document).run(); }

}  // namespace sinew
