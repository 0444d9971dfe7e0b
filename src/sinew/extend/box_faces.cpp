#include "sinew/extend/box_faces.h"

#include <array>

namespace sinew {

Vec3 half_size(const PlainBuilder& b, std::int32_t node) {
    const Node& drawn = b.drawn(node);
    return drawn.size ? Vec3(0.5 * *drawn.size) : Vec3::Constant(b.radius(node));
}

bool is_box_joint(const PlainBuilder& b, std::int32_t node) {
    if (b.is_root(node) || b.degree(node) > 2) return true;
    for (const std::int32_t bone : b.bones(node))
        if (b.is_pit(b.other(bone, node))) return true;
    return false;
}

Face face_of(const Form& box, const Vec3& centre, int index) {
    const std::array<Vec3, 3> axis{box.x, box.y, box.z};
    const int k = index / 2, u = (k + 1) % 3, v = (k + 2) % 3;
    const double sign = index % 2 == 0 ? 1 : -1;
    const Vec3 z = sign * axis[k];
    return {centre + box.half[k] * z, {axis[u], z.cross(axis[u]), z}, box.half[u], box.half[v]};
}

int face_towards(const Form& box, const Vec3& offset) {
    const Vec3 local = box.local(offset);
    int k = 0;
    local.cwiseAbs().maxCoeff(&k);
    return 2 * k + (local[k] < 0 ? 1 : 0);
}

}  // namespace sinew
