#include "sinew/sqm/surface/joint_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sinew/extend/bodies.h"
#include "sinew/sqm/surface/bisect.h"

namespace sinew::sqm {

double BeamFrom::exit(const Vec3& ray) const {
    const double p = std::abs(ray.dot(x)), q = std::abs(ray.dot(y)), h = ray.dot(z);
    if (h <= 0) {  // behind: a cap as deep as the outline is narrow
        const double depth = near.minCoeff();
        const Vec3 local(p / near.x(), q / near.y(), -h / depth);
        return section == Section::rectangular ? 1 / std::max({local.x(), local.y(), local.z()})
                                               : 1 / local.norm();
    }
    // The outline at height t h is near + (far - near) t h / length.
    const auto side = [&](double lateral, double from, double to) {
        const double closing = lateral - h * (to - from) / length;
        return closing > 0 ? from / closing : std::numeric_limits<double>::infinity();
    };
    const double end = length / h;
    if (section == Section::rectangular)
        return std::min({end, side(p, near.x(), far.x()), side(q, near.y(), far.y())});
    // The equation for the distance is of the fourth degree, as both half extents change along the beam.
    constexpr int halvings = 40;  // to 1e-12 of the beam's length: far below the rounding of a mesh, 6e-8
    return bisect(0, end, halvings,
                  [&](double distance) {
                      const Vec2 half = near + distance * h / length * (far - near);
                      return Vec2(p * distance / half.x(), q * distance / half.y()).squaredNorm() < 1;
                  })
        .first;
}

double PitShape::press(const Vec3& centre, const Vec3& ray, double distance) const {
    const Vec3 o = local(centre - middle), d = local(ray);
    if ((o + distance * d).squaredNorm() >= 1) return distance;
    const double a = d.squaredNorm(), b = o.dot(d), c = o.squaredNorm() - 1, root = b * b - a * c;
    return root > 0 ? std::min(distance, (-b - std::sqrt(root)) / a) : distance;
}

double exit_without_dents(const Network& network, const JointSurfaces& surfaces, std::int32_t joint,
                          const Vec3& ray) {
    const Form* body = surfaces.body[joint];
    if (body && body->kind == Form::Kind::box) return exit_of_box(*body, ray);
    if (body && body->kind == Form::Kind::ball) return exit_of_ellipsoid(*body, ray);
    double distance = 0;
    if (const CrowdedSlots* crowd = surfaces.only_cones[joint] ? surfaces.crowd(joint) : nullptr)
        return crowd->exit(surfaces.cones(network, joint), ray);
    for (std::int32_t slot = network.slot_first[joint]; slot < network.slot_first[joint + 1]; ++slot) {
        if (surfaces.kind[slot] == SlotKind::cone)
            distance = std::max(distance, surfaces.cone[slot].exit(ray));
        if (surfaces.kind[slot] == SlotKind::beam)
            distance = std::max(distance, surfaces.beams[surfaces.extra[slot]].exit(ray));
        if (distance == 0)
            distance = surfaces.cone[slot].near;  // only pits and bare surface: the ball itself
    }
    return distance;
}

}  // namespace sinew::sqm
