#include "sinew/skeleton/rewire.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "sinew/skeleton/frames.h"

namespace sinew {
namespace {

/// Sets of nodes that are joined.
class Unions {
  public:
    explicit Unions(std::size_t count) : above_(count) { std::iota(above_.begin(), above_.end(), 0); }
    /// False where they were joined before.
    bool join(std::int32_t a, std::int32_t b) {
        a = top(a);
        b = top(b);
        above_[std::max(a, b)] = std::min(a, b);
        return a != b;
    }
    bool joined(std::int32_t a, std::int32_t b) { return top(a) == top(b); }

  private:
    std::int32_t top(std::int32_t i) {
        while (above_[i] != i) i = above_[i] = above_[above_[i]];
        return i;
    }
    std::vector<std::int32_t> above_;
};

/// Which bones join two nodes that none before them joins.
std::vector<char> first_of_their_kind(std::span<const Bone> bones) {
    std::vector<std::pair<Bone, std::size_t>> sorted;
    sorted.reserve(bones.size());
    for (std::size_t b = 0; b < bones.size(); ++b) {
        const auto [low, high] = std::minmax(bones[b][0], bones[b][1]);
        sorted.push_back({{low, high}, b});
    }
    std::ranges::sort(sorted);
    std::vector<char> first(bones.size(), 0);
    for (std::size_t s = 0; s < sorted.size(); ++s) {
        const auto& [bone, b] = sorted[s];
        first[b] = bone[0] != bone[1] && (s == 0 || sorted[s - 1].first != bone);
    }
    return first;
}

}  // namespace

void set_bones(Document& document, std::span<const Bone> bones, std::span<const Bone> links) {
    for (Node& node : document.nodes) node.parent = -1;
    document.links.clear();
    Unions trees(document.nodes.size());
    std::vector<Bone> all(bones.begin(), bones.end());
    all.insert(all.end(), links.begin(), links.end());
    const std::vector<char> first = first_of_their_kind(all);
    for (std::size_t b = 0; b < all.size(); ++b) {
        if (!first[b]) continue;
        const auto [parent, child] = all[b];
        if (b < bones.size() && document.nodes[child].parent < 0 && trees.join(parent, child))
            document.nodes[child].parent = parent;
        else
            document.links.push_back(all[b]);
    }
}

std::int32_t append_copy(Document& document, std::int32_t node, std::int64_t id) {
    document.nodes.push_back(document.nodes[node]);
    document.nodes.back().id = id;
    for (std::vector<std::string>* table : {&document.names, &document.extras})
        if (!table->empty()) table->push_back(std::string((*table)[node]));
    return static_cast<std::int32_t>(document.nodes.size()) - 1;
}

void drop_nodes(Document& document, const std::vector<char>& gone) {
    std::vector<std::int32_t> index(document.nodes.size(), -1);
    std::int32_t kept = 0;
    for (std::size_t i = 0; i < index.size(); ++i)
        if (!gone[i]) index[i] = kept++;
    auto compact = [&](auto& table) {
        if (table.empty()) return;
        for (std::size_t i = 0; i < index.size(); ++i)
            if (index[i] >= 0 && static_cast<std::size_t>(index[i]) != i)
                table[index[i]] = std::move(table[i]);
        table.resize(kept);
    };
    compact(document.nodes);
    compact(document.names);
    compact(document.extras);
    for (Node& node : document.nodes) node.parent = node.parent < 0 ? -1 : index[node.parent];
    for (Bone& link : document.links) link = {index[link[0]], index[link[1]]};
}

void round_off_inner_tips(Document& document) {
    const std::vector<Bone> bones = bones_of(document);
    const Adjacency around = adjacency(static_cast<std::int32_t>(document.nodes.size()), bones);
    for (std::int32_t i = 0; i < std::ssize(document.nodes); ++i) {
        NodeType& type = document.nodes[i].type;
        if (is_tip(type) && around.degree(i) != 1) type = NodeType::sphere;
    }
    for (const auto& [a, b] : bones)  // a pit needs a surface
        if (document.nodes[a].type == NodeType::negative && document.nodes[b].type == NodeType::negative)
            document.nodes[a].type = NodeType::sphere;
}

bool has_axes(const Document& document, const std::vector<Bone>& bones, const Adjacency& around,
              std::int32_t i) {
    // A round ball has axes too, as has what a dent is pressed into: the bones that carry its bare surface
    // stand along them.
    const Node& node = document.nodes[i];
    if (node.type == NodeType::cube || node.type == NodeType::ball || node.type == NodeType::negative ||
        node.section == Section::rectangular || node.scale[0] != node.scale[1] || around.degree(i) == 0)
        return true;
    return std::ranges::any_of(around.bones(i), [&](std::int32_t b) {
        return document.nodes[bones[b][bones[b][0] == i ? 1 : 0]].type == NodeType::negative;
    });
}

void turn_to(Document& document, const std::vector<Bone>& bones, const Adjacency& around, std::int32_t i,
             const Mat3& frame, double likely) {
    Node& node = document.nodes[i];
    node.roll = 0;
    node.rotation.reset();
    Mat3 turn = local_frame(document, bones, around, i).transpose() * frame;
    if (turn(2, 2) < 0) turn *= Vec3(1, -1, -1).asDiagonal();
    node.roll = std::atan2(turn(1, 0), turn(0, 0)) * 180 / std::numbers::pi;
    for (const double exact : {0.0, likely, -likely, std::round(node.roll)}) {
        if (std::abs(std::remainder(node.roll - exact, 180)) > 1e-9) continue;
        node.roll = exact;
        break;
    }
    const bool rolls = std::abs(turn(2, 2) - 1) < 1e-9;
    if (rolls || !takes_rotation(node, around.degree(i))) return;
    node.roll = 0;
    node.rotation = Quat(frame);
    if (node.rotation->w() < 0) node.rotation->coeffs() *= -1;
}

FreshIds::FreshIds(const Document& document) {
    constexpr std::int64_t enough = std::int64_t{1} << 62;
    std::int64_t highest = -1;
    for (const Node& node : document.nodes) highest = std::max(highest, node.id);
    if (highest < enough) {
        next_ = highest + 1;
        return;
    }
    for (const Node& node : document.nodes) taken_.push_back(node.id);
    std::ranges::sort(taken_);
}

std::int64_t FreshIds::next() {
    for (; at_ < taken_.size() && taken_[at_] <= next_; ++at_)
        if (taken_[at_] == next_) ++next_;
    return next_++;
}

}  // namespace sinew
