#include "sinew/sqm/rings/ring_form.h"

#include "sinew/extend/frames.h"

namespace sinew::sqm {

void take_form(const Form& form, Station& ring) {
    Frame frame{form.x, form.y, form.z};
    if (frame.z.dot(ring.tangent) < 0) frame = {frame.x, -frame.y, -frame.z};
    if (form.fixed)
        ring.tangent = frame.z;
    else
        frame = turn_frame(frame, ring.tangent);
    ring.form_x = frame.x;
    ring.half = {form.half.x(), form.half.y()};
    const bool rectangular = form.section == Section::rectangular;
    const bool plain = !rectangular && ring.half.x() == ring.half.y() && !form.fixed && form.sharpness == 0;
    if (plain) return;  // stays on the round cones
    ring.shape = rectangular ? RingShape::outline : RingShape::circle;
    ring.crease = static_cast<float>(form.sharpness);
    if (form.fixed) {
        ring.round = !rectangular && ring.half.x() == ring.half.y();
        ring.corners = rectangular;
    }
    if (rectangular) ring.lines = static_cast<float>(infinitely_sharp);
}

void blend_forms(const PathWork& w, std::int32_t bone, double share, Station& ring) {
    const auto outline = [&](std::int32_t i) {
        const Form* f = w.form(i);
        return f && f->kind != Form::Kind::ball && f->kind != Form::Kind::box ? f : nullptr;
    };
    const Form *a = outline(bone), *b = outline(bone + 1);
    const Form* leads = w.is_shaped(bone) ? a : b ? b : a;
    if (!leads) return;
    Form form = *leads;
    form.fixed = false;
    form.sharpness = 0;
    const auto half = [&](const Form* f, std::int32_t i) -> Vec3 {
        return f ? f->half : Vec3(Vec3::Constant(w.radius(i)));
    };
    form.half = (1 - share) * half(a, bone) + share * half(b, bone + 1);
    if (!a || !b || a->section != b->section) form.section = Section::round;
    take_form(form, ring);
}

}  // namespace sinew::sqm
