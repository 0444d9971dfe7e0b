/// @file near_directions.h
/// Which of many directions are near a place: a grid of cells in a hash table.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "sinew/base/vec.h"

namespace sinew::sqm {

/// Joints of more bones than this have their cells found by what is linear in them, but for a logarithm;
/// others by what is simpler, and quadratic.
inline constexpr std::int32_t crowd = 256;

/// Points that were added, found by place. Linear in them as long as not many lie in one cell.
class NearDirections {
  public:
    /// @param reach  how far from a place points are found for certain
    /// @param most   points that will be added at most
    NearDirections(double reach, std::size_t most) : reach_(reach) {
        std::size_t size = 16;
        while (size < 2 * most) size *= 2;
        head_.assign(size, -1);
        next_.reserve(most);
    }
    NearDirections(double reach, std::span<const Vec3> points) : NearDirections(reach, points.size()) {
        for (const Vec3& p : points) add(p);
    }
    /// The next point, whose index is how many came before it.
    void add(const Vec3& point) {
        std::int32_t& head = head_[slot(cell(point.x()), cell(point.y()), cell(point.z()))];
        next_.push_back(head);
        head = static_cast<std::int32_t>(next_.size()) - 1;
    }
    /// visit(index) for every point within reach of a place, and for some others, some of them twice.
    template <class Visit>
    void for_near(const Vec3& place, Visit visit) const {
        const std::int64_t x = cell(place.x()), y = cell(place.y()), z = cell(place.z());
        for (std::int64_t i = x - 1; i <= x + 1; ++i)
            for (std::int64_t j = y - 1; j <= y + 1; ++j)
                for (std::int64_t k = z - 1; k <= z + 1; ++k)
                    for (std::int32_t at = head_[slot(i, j, k)]; at >= 0; at = next_[at]) visit(at);
    }

  private:
    std::int64_t cell(double x) const { return static_cast<std::int64_t>(std::floor(x / reach_)); }
    std::size_t slot(std::int64_t x, std::int64_t y, std::int64_t z) const {
        auto mixed = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15u ^
                     static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4fu ^
                     static_cast<std::uint64_t>(z) * 0x165667b19e3779f9u;
        mixed ^= mixed >> 29;
        mixed *= 0xbf58476d1ce4e5b9u;
        return static_cast<std::size_t>(mixed >> 32) & (head_.size() - 1);
    }

    double reach_;
    std::vector<std::int32_t> head_, next_;
};

}  // namespace sinew::sqm
