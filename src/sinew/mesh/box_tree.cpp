#include "sinew/mesh/box_tree.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace sinew {
namespace {

struct MortonKey {
    std::uint64_t code;
    std::uint32_t item;
};

/// Puts two zeros between the bits of a number of 21 bits.
std::uint64_t spread_bits(std::uint64_t x) {
    x = (x | x << 32) & 0x1f00000000ffff;
    x = (x | x << 16) & 0x1f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    x = (x | x << 2) & 0x1249249249249249;
    return x;
}

bool is_finite(const Box& box) { return box.low.allFinite() && box.high.allFinite(); }

Vec3 centre(const Box& box) { return (box.low.cast<double>() + box.high.cast<double>()) / 2; }

/// The boxes along the Morton curve through their centres.
std::vector<MortonKey> morton_keys(std::span<const Box> boxes) {
    Eigen::AlignedBox3d all;
    std::vector<MortonKey> keys;
    keys.reserve(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (!is_finite(boxes[i])) continue;
        all.extend(centre(boxes[i]));
        keys.push_back({0, static_cast<std::uint32_t>(i)});
    }
    const double extent = keys.empty() ? 0 : all.sizes().maxCoeff();
    const double scale = extent > 0 ? 0x1fffff / extent : 0;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, keys.size(), 8192), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const Vec3 at = (centre(boxes[keys[i].item]) - all.min()) * scale;
            for (int k = 0; k < 3; ++k) keys[i].code |= spread_bits(static_cast<std::uint64_t>(at[k])) << k;
        }
    });
    return keys;
}

/// Sorts by the codes' 63 bits, 11 at a time; items of one code stay in ascending order.
void radix_sort(std::vector<MortonKey>& keys) {
    constexpr int bits = 11, passes = 6;
    constexpr std::size_t digits = 1 << bits;
    std::vector<MortonKey> other(keys.size());
    for (int pass = 0; pass < passes; ++pass) {
        auto digit = [&](const MortonKey& key) { return key.code >> (bits * pass) & (digits - 1); };
        std::array<std::size_t, digits> first{};
        for (const MortonKey& key : keys) ++first[digit(key)];
        if (std::find(first.begin(), first.end(), keys.size()) != first.end()) continue;
        std::size_t sum = 0;
        for (std::size_t& entry : first) sum += std::exchange(entry, sum);
        for (const MortonKey& key : keys) other[first[digit(key)]++] = key;
        keys.swap(other);
    }
}

std::vector<Box> level_above(const std::vector<Box>& below) {
    std::vector<Box> level((below.size() + BoxTree::width - 1) / BoxTree::width);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, level.size(), 4096), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i)
            for (std::size_t c = i * BoxTree::width; c < std::min((i + 1) * BoxTree::width, below.size());
                 ++c)
                level[i].extend(below[c]);
    });
    return level;
}

}  // namespace

BoxTree build_box_tree(std::span<const Box> boxes) {
    std::vector<MortonKey> keys = morton_keys(boxes);
    radix_sort(keys);
    BoxTree tree;
    std::vector<Box> leaves;
    leaves.reserve(keys.size());
    tree.items.reserve(keys.size());
    for (const MortonKey& key : keys) {
        tree.items.push_back(key.item);
        leaves.push_back(boxes[key.item]);
    }
    tree.levels.push_back(std::move(leaves));
    while (tree.levels.back().size() > 1) tree.levels.push_back(level_above(tree.levels.back()));
    return tree;
}

std::vector<BoxTreePair> split_overlaps(const BoxTree& tree, std::size_t enough) {
    std::vector<BoxTreePair> pairs, below;
    if (!tree.items.empty()) pairs.push_back({static_cast<std::uint32_t>(tree.levels.size() - 1), 0, 0});
    while (!pairs.empty() && pairs.front().level > 0 && pairs.size() < enough) {
        below.clear();
        for (const BoxTreePair& pair : pairs)
            for_each_child_pair(tree, pair, [&](const BoxTreePair& child) { below.push_back(child); });
        pairs.swap(below);
    }
    return pairs;
}

}  // namespace sinew
