#include "sinew/extend/sections.h"

namespace sinew {

Form section_form(const PlainBuilder& builder, std::int32_t node) {
    const Node& drawn = builder.drawn(node);
    const Frame frame = builder.frame(node);
    Form form;
    form.section = drawn.section;
    form.x = frame.x, form.y = frame.y, form.z = frame.z;
    form.half = builder.radius(node) * Vec3(drawn.scale[0], drawn.scale[1], drawn.scale[2]);
    form.sharpness = drawn.joint;
    return form;
}

void add_section(PlainBuilder& builder, std::int32_t node) {
    const Node& drawn = builder.drawn(node);
    const std::int32_t degree = builder.degree(node);
    if (builder.is_pit(node)) return;  // its section is the pit's opening
    Form form = section_form(builder, node);
    const bool shaped =
        drawn.section != Section::round || drawn.scale != std::array<double, 3>{1, 1, 1} || drawn.joint > 0;
    if (degree == 0) {
        if (!shaped) return;
        form.kind = drawn.section == Section::round ? Form::Kind::ball : Form::Kind::box;
        builder.set_form(node, form);
        return;
    }
    const bool is_end = degree == 1 && !builder.is_pit(builder.other(builder.bones(node)[0], node));
    if (is_end && drawn.type == NodeType::cone) {
        builder.set_cap(node, Cap::point);
        builder.set_radius(node, 0);
        return;
    }
    if (is_end && drawn.type == NodeType::hemisphere) {
        builder.set_cap(node, Cap::flat);
        form.fixed = true;
        form.sharpness = infinitely_sharp;
        builder.set_form(node, form);
        return;
    }
    if (!shaped) return;
    if (degree > 2) form.kind = Form::Kind::blend;
    builder.set_form(node, form);
}

}  // namespace sinew
