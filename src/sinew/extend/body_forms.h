/// @file body_forms.h
/// The forms that bodies are made of.
#pragma once

#include "sinew/extend/builder.h"

namespace sinew {

/// A ring in the plane of x and y of a frame, whatever its bones do.
inline Form ring_form(const Frame& frame, double half_x, double half_y, Section section, double sharpness) {
    Form form;
    form.section = section;
    form.x = frame.x, form.y = frame.y, form.z = frame.z;
    form.half = {half_x, half_y, 1};
    form.fixed = true;
    form.sharpness = sharpness;
    return form;
}

/// The body of a joint, turned as its node is.
inline Form body_form(const PlainBuilder& b, std::int32_t node, Form::Kind kind, const Vec3& half) {
    const Frame frame = b.frame(node);
    Form form;
    form.kind = kind;
    form.x = frame.x, form.y = frame.y, form.z = frame.z;
    form.half = half;
    form.sharpness = b.drawn(node).joint;
    return form;
}

}  // namespace sinew
