/// @file crowded_slots.h
/// The cones of a joint of very many bones, as a tree by direction: a ray meets those near it only.
///
/// Each node of the tree bounds what its cones can answer: how far a ray inside them may come, and where the
/// joint has to end along their bones. So nearly all are passed over, and the answers are those of a search
/// through all of them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sinew/base/round_cone.h"
#include "sinew/base/vec.h"

namespace sinew::sqm {

/// Arguments `cones` and `limits` are the same every time, one entry a slot of the joint.
class CrowdedSlots {
  public:
    explicit CrowdedSlots(std::span<const ConeFrom> cones);
    /// Once the limits are known; until then there are none.
    void set_limits(std::span<const double> limits);

    /// The furthest exit of a ray from any cone.
    double exit(std::span<const ConeFrom> cones, const Vec3& ray) const;
    /// `distance` along a ray, or as far as the limits let it come.
    double limited(std::span<const ConeFrom> cones, std::span<const double> limits, const Vec3& ray,
                   double distance) const;
    /// The greatest cosine between a slot's axis and that of another.
    double nearest_cosine(std::span<const ConeFrom> cones, std::int32_t slot) const;

  private:
    struct Node {
        Vec3 axis = Vec3::Zero();
        double spread = 0;                ///< chord from the axis to the furthest one below
        double width = 0, length = 0;     ///< of the widest, and of the longest one
        double slope = 1;                 ///< the least sine of a side; 0 where a ball is in another one
        double limit = 0;                 ///< the least one
        std::int32_t begin = 0, end = 0;  ///< in slots_
        std::int32_t child = -1;          ///< the first of two; -1: a leaf
    };
    void bound(Node& node, std::span<const ConeFrom> cones) const;
    void split(std::int32_t node, std::span<const ConeFrom> cones);
    static double chord_to(const Node& node, const Vec3& ray);
    template <class Worth, class Known, class See>
    void search(Worth worth, Known known, See see) const;

    std::vector<Node> nodes_;  // parents before their children
    std::vector<std::int32_t> slots_;
};

}  // namespace sinew::sqm
