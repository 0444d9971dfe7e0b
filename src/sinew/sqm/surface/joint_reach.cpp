#include "sinew/sqm/surface/joint_reach.h"

#include <algorithm>

#include "sinew/sqm/surface/blend.h"
#include "sinew/sqm/surface/dents.h"

namespace sinew::sqm {

double exit_of_joint(const Network& network, const JointSurfaces& surfaces, std::int32_t joint,
                     const Vec3& centre, const Vec3& ray) {
    if (surfaces.only_cones[joint]) {
        // Between so many bones no fillet shows.
        if (const CrowdedSlots* crowd = surfaces.crowd(joint))
            return crowd->exit(surfaces.cones(network, joint), ray);
        double distance = 0;
        for (std::int32_t slot = network.slot_first[joint]; slot < network.slot_first[joint + 1]; ++slot)
            distance = std::max(distance, surfaces.cone[slot].exit(ray));
        return blended_exit(network, surfaces, joint, ray, distance);
    }
    return press_dents(surfaces, joint, centre, ray, exit_without_dents(network, surfaces, joint, ray));
}

double reach_of_joint(const Network& n, const JointSurfaces& surfaces, std::int32_t joint, const Vec3& centre,
                      const Vec3& ray) {
    double distance = exit_of_joint(n, surfaces, joint, centre, ray);
    if (const CrowdedSlots* crowd = surfaces.crowd(joint))
        return crowd->limited(surfaces.cones(n, joint), surfaces.limits(n, joint), ray, distance);
    for (std::int32_t slot = n.slot_first[joint]; slot < n.slot_first[joint + 1]; ++slot) {
        const double along = ray.dot(surfaces.cone[slot].axis);
        if (along > 0 && distance * along > surfaces.limit[slot]) distance = surfaces.limit[slot] / along;
    }
    return distance;
}

}  // namespace sinew::sqm
