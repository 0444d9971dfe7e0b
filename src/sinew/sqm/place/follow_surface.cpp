#include "sinew/sqm/place/follow_surface.h"

#include "sinew/sqm/rings/path_frame.h"
#include "sinew/sqm/surface/dents.h"
#include "sinew/sqm/surface/joint_reach.h"

namespace sinew::sqm {
namespace {

// Radians between two directions that have a great circle between them: it is divided by the sine of that.
constexpr double least_angle = 1e-6;
constexpr double most_angle = 3.1;  // on the far side a hair decides which way round the joint it goes

}  // namespace

Vec3 follow_surface(const Parts& d, const PathEnd& end, const Vec3& at_joint, const Vec3& on_ring,
                    double share) {
    const Network& n = d.network;
    const std::int32_t joint = end.joint, slot = n.slot_first[joint] + end.slot;
    const Vec3& centre = d.skeleton.position[n.joint_node[joint]];
    const Form* body = d.surfaces.body[joint];
    const auto direction_to = [&](const Vec3& place) {
        const Vec3 out = place - centre;
        return to_ball_space(body, out / out.norm());
    };
    const GreatCircle circle(direction_to(at_joint), direction_to(on_ring));
    if (!(circle.angle > least_angle && circle.angle < most_angle))
        return at_joint + share * (on_ring - at_joint);
    const Vec3 ray = from_ball_space(body, circle.at(share));
    if (d.surfaces.kind[slot] == SlotKind::pit && has_groove(d.surfaces, joint) &&
        on_rim(n, d.surfaces, joint, centre, at_joint) && on_rim(n, d.surfaces, joint, centre, on_ring)) {
        const PitShape& pit = d.surfaces.pits[d.surfaces.extra[slot]];
        const Vec3 rim = rim_towards(n, d.surfaces, joint, pit, centre, ray);
        return centre + exit_without_dents(n, d.surfaces, joint, rim) * rim;
    }
    return centre + reach_of_joint(n, d.surfaces, joint, centre, ray) * ray;
}

}  // namespace sinew::sqm
