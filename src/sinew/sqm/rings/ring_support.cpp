#include "sinew/sqm/rings/ring_support.h"

#include <cmath>

#include "sinew/base/portable_math.h"

namespace sinew::sqm {
namespace {

constexpr double corner = 0.1;    // radians between two slopes from which their ring needs others beside it
constexpr double straight = 0.6;  // cosine of the bend from which its arms are held straight

double slope(const PathWork& w, std::int32_t bone) {
    return portable::angle_of(w.radius(bone + 1) - w.radius(bone),
                              (w.position(bone + 1) - w.position(bone)).norm());
}

bool is_bend(const PathWork& w, std::int32_t i) {
    const Form* form = w.form(i);
    if (form && (form->kind != Form::Kind::ring || form->fixed || form->sharpness > 0)) return false;
    const auto is_tube = [&](std::int32_t bone) {
        return w.kind((bone + w.bone_count()) % w.bone_count()) == BoneKind::tube;
    };
    return is_tube(i - 1) && is_tube(i) && w.direction(i - 1).dot(w.direction(i)) < straight;
}

}  // namespace

bool is_base_of_tip(const PathWork& w, std::int32_t i) {
    if (w.closed) return false;
    const bool tip = (i == 1 && w.s.cap[w.node(0)] == Cap::point) ||
                     (i + 2 == w.count() && w.s.cap[w.node(i + 1)] == Cap::point);
    if (!tip || (w.form(i) && w.form(i)->kind == Form::Kind::ring)) return false;
    return std::abs(slope(w, i - 1) - slope(w, i)) > corner;
}

bool wants_support(const PathWork& w, std::int32_t i) {
    if (!w.options.support) return false;
    const std::int32_t last = w.count() - 1;
    if (!w.closed && (i == 0 || i == last))
        return !(i == 0 ? w.near : w.far).any() && w.s.cap[w.node(i)] == Cap::round && !w.is_rectangular(i);
    return is_base_of_tip(w, i) || is_bend(w, i);
}

}  // namespace sinew::sqm
