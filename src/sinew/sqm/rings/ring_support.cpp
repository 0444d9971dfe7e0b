#include "sinew/sqm/rings/ring_support.h"

#include <algorithm>
#include <cmath>

#include "sinew/base/portable_math.h"

namespace sinew::sqm {
namespace {

constexpr double corner = 0.1;  // radians between two slopes from which their ring needs others beside it
/// By how much of the radius a smooth surface may cut a bend: a cubic spline through rings as far apart as the bones are
/// long passes a sixth of the second difference inside the node. With 0.1 / 0.2 / 0.35 the worst percent of the area of 38
/// skeletons of others swells by 0.07 / 0.07 / 0.08 r (without: 0.14), with 326,000 / 292,000 / 262,000 vertices (223,000).
constexpr double deepest_cut = 0.25;
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
    if (!is_tube(i - 1) || !is_tube(i)) return false;
    const double cosine = w.direction(i - 1).dot(w.direction(i));
    if (cosine < straight) return true;
    const double shorter =
        std::min((w.position(i) - w.position(i - 1)).norm(), (w.position(i + 1) - w.position(i)).norm());
    const double cut = shorter / 6 * std::sqrt(2 * std::max(0.0, 1 - cosine));
    return cut > deepest_cut * w.radius(i);
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
