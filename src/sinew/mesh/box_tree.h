/// @file box_tree.h
/// A bounding-volume hierarchy over boxes, built in linear time: boxes in Morton order, then level by level.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "sinew/base/vec.h"

namespace sinew {

/// Closed; holds nothing as long as low > high. A box with a coordinate that is not finite is left out of
/// trees.
struct Box {
    Vec3f low = Vec3f::Constant(std::numeric_limits<float>::infinity());
    Vec3f high = Vec3f::Constant(-std::numeric_limits<float>::infinity());

    void extend(const Vec3f& point) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    void extend(const Box& box) {
        low = low.cwiseMin(box.low);
        high = high.cwiseMax(box.high);
    }
    bool overlaps(const Box& other) const {
        return low.x() <= other.high.x() && other.low.x() <= high.x() && low.y() <= other.high.y() &&
               other.low.y() <= high.y() && low.z() <= other.high.z() && other.low.z() <= high.z();
    }
};

/// Level 0 holds the boxes themselves, in the order `items`; node i of level k + 1 bounds `width` nodes of
/// level k, from node width * i on, or as many as there are. The last level has one node, or none where
/// there are no boxes.
struct BoxTree {
    static constexpr std::size_t width = 4;
    std::vector<std::uint32_t> items;  ///< indices of the boxes, near ones together
    std::vector<std::vector<Box>> levels;

    /// The children of a node of the level `level` > 0: a range of nodes of the level below.
    std::size_t first_child(std::size_t node) const { return node * width; }
    std::size_t end_child(std::size_t level, std::size_t node) const {
        return std::min((node + 1) * width, levels[level - 1].size());
    }
};

BoxTree build_box_tree(std::span<const Box> boxes);

/// Two nodes of one level whose boxes overlap, or the same node twice; the lower one first.
struct BoxTreePair {
    std::uint32_t level;
    std::uint32_t low;
    std::uint32_t high;
};

/// Calls visit(pair) for the pairs of children, one level down, that overlap. All pairs of overlapping boxes
/// are found from the root's own pair on, each once.
template <class Visit>
void for_each_child_pair(const BoxTree& tree, const BoxTreePair& pair, const Visit& visit) {
    const std::vector<Box>& boxes = tree.levels[pair.level - 1];
    for (std::size_t a = tree.first_child(pair.low); a < tree.end_child(pair.level, pair.low); ++a)
        for (std::size_t b = std::max(a, tree.first_child(pair.high));
             b < tree.end_child(pair.level, pair.high); ++b)
            if (a == b || boxes[a].overlaps(boxes[b]))
                visit({pair.level - 1, static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
}

/// Calls visit(a, b) for all pairs of different boxes below `pair` that overlap, as their places in
/// tree.items.
template <class Visit>
void for_each_overlap(const BoxTree& tree, const BoxTreePair& pair, const Visit& visit) {
    if (pair.level > 0)
        for_each_child_pair(tree, pair,
                            [&](const BoxTreePair& child) { for_each_overlap(tree, child, visit); });
    else if (pair.low != pair.high)
        visit(pair.low, pair.high);
}

/// The pairs of overlapping nodes, from the root down, as soon as there are `enough` or the boxes are
/// reached: work to share out. All pairs of overlapping boxes are below them, each once.
std::vector<BoxTreePair> split_overlaps(const BoxTree& tree, std::size_t enough);

}  // namespace sinew
