#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "sinew/extend/extend.h"

namespace sinew {
namespace {

/// Images of all nodes under the reflection of one axis; empty if one has none.
class MirrorSearch {
  public:
    MirrorSearch(const Plain& skeleton, int axis) : s_(skeleton), axis_(axis) {}

    /// @param flat  is every node in the plane itself?
    std::vector<std::int32_t> run(bool flat) {
        if (!extent_is_even(flat)) return {};
        sort_nodes();
        std::vector<std::int32_t> image;
        for (std::int32_t i = 0; i < s_.node_count(); ++i) {
            const std::int32_t j = find(key(i, true));
            if (j < 0 || !forms_match(i, j)) return {};
            image.push_back(j);
        }
        return bones_follow(s_.bones, image) ? image : std::vector<std::int32_t>{};
    }

  private:
    using Key = std::array<double, 7>;
    Key key(std::int32_t i, bool reflected) const {
        Vec3 p = s_.position[i];
        if (reflected) p[axis_] = -p[axis_];
        const Form* form = s_.form(i);
        return {p.x(),
                p.y(),
                p.z(),
                s_.radius[i],
                static_cast<double>(s_.cap[i]),
                s_.pit_depth[i],
                form ? 1.0 + static_cast<double>(form->kind) : 0.0};
    }
    /// Most skeletons are found out at once.
    bool extent_is_even(bool flat) const {
        double low = 0, high = 0;
        for (const Vec3& p : s_.position) low = std::min(low, p[axis_]), high = std::max(high, p[axis_]);
        return low == -high && (high == 0) == flat;
    }
    void sort_nodes() {
        sorted_.reserve(s_.position.size());
        for (std::int32_t i = 0; i < s_.node_count(); ++i) sorted_.emplace_back(key(i, false), i);
        std::sort(sorted_.begin(), sorted_.end());
    }
    /// The one node with a key; -1 if there is none, or more than one, which could not be told apart.
    std::int32_t find(const Key& wanted) const {
        const auto at = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair(wanted, std::int32_t{0}));
        if (at == sorted_.end() || at->first != wanted) return -1;
        return at + 1 != sorted_.end() && at[1].first == wanted ? -1 : at->second;
    }
    /// The outlines, which do not change when an axis is turned round, must be each other's reflection. Both
    /// nodes have the same key: both have a form, or none.
    bool forms_match(std::int32_t i, std::int32_t j) const {
        const Form *a = s_.form(i), *b = s_.form(j);
        if (!a) return true;
        const auto reflected = [&](Vec3 v) { return v[axis_] = -v[axis_], v; };
        constexpr double rounding = 1e-9;  // frames and extents are computed; positions are compared exactly
        const auto along = [](const Vec3& u, const Vec3& v) { return std::abs(u.dot(v)) > 1 - rounding; };
        const bool straight =
            along(reflected(a->x), b->x) && (a->half - b->half).norm() <= rounding * a->half.norm();
        const Vec3 swapped(b->half.y(), b->half.x(), b->half.z());
        const bool crossed =
            along(reflected(a->x), b->y) && (a->half - swapped).norm() <= rounding * a->half.norm();
        return along(reflected(a->z), b->z) && (straight || crossed) && a->section == b->section &&
               a->sharpness == b->sharpness;
    }

    const Plain& s_;
    int axis_;
    std::vector<std::pair<Key, std::int32_t>> sorted_;
};

}  // namespace

Automorphism find_mirror(const Plain& skeleton) {
    Automorphism mirror;
    for (const bool flat : {false, true})
        for (int axis = 0; axis < 3; ++axis) {
            mirror.image = MirrorSearch(skeleton, axis).run(flat);
            if (mirror.image.empty()) continue;
            mirror.order = 2;
            mirror.generator(axis, axis) = -1;
            return mirror;
        }
    return {};
}

}  // namespace sinew
