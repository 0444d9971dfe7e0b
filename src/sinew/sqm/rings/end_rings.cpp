#include "sinew/sqm/rings/end_rings.h"

#include <algorithm>
#include <cmath>

#include "sinew/base/portable_math.h"
#include "sinew/sqm/rings/ring_form.h"

namespace sinew::sqm {
namespace {

constexpr float pit_rings[] = {1.0f, 0.94f, 0.77f, 0.42f};  // widths of the rings down a dent

/// Rings of a round end: from where the cone touches the ball to just before the pole.
void add_round_end(PathWork& w, std::int32_t leaf, bool at_end) {
    const std::int32_t other = at_end ? leaf - 1 : 1;
    const Vec3 outward = (w.position(leaf) - w.position(other)).normalized();
    const double length = (w.position(leaf) - w.position(other)).norm(), r = w.radius(leaf);
    const Form* form = w.is_shaped(leaf) ? w.form(leaf) : nullptr;
    // Of a smooth surface, on the round cone as scaled; else forms go straight from node to node.
    const bool scaled =
        form && w.options.support && form->section == Section::round && !form->fixed && form->sharpness == 0;
    const double begin =
        form && !scaled ? 0 : portable::arc_sine(std::clamp((w.radius(other) - r) / length, -0.9, 0.9));
    const int rings = std::max(1, static_cast<int>(std::lround(w.sides * (M_PI / 2 - begin) / (2 * M_PI))));
    for (int i = 0; i < rings; ++i) {
        const int step = at_end ? i : rings - 1 - i;
        const double angle = begin + (M_PI / 2 - begin) * step / rings;
        const auto [sine, cosine] = portable::sine_cosine(angle);
        const Vec3 centre = w.position(leaf) + r * sine * outward;
        if (at_end && w.near.any() && w.count() == 2 && length + r * sine < w.near.reach + 0.15 * r) continue;
        Station& ring = add_ring(w, centre, w.way(at_end ? leaf - 1 : 0), r * cosine, at_end ? leaf - 1 : 0,
                                 at_end ? 1 : 0);
        ring.node = w.node(leaf);
        ring.fit = RingFit::cap;
        if (!form) continue;
        take_form(*form, ring);
        if (ring.shape != RingShape::circle || ring.crease > 0) ring.fit = RingFit::through;
        ring.half *= cosine;
        ring.crease = step == 0 ? ring.crease : 0;
    }
}

void add_flat_end(PathWork& w, std::int32_t leaf, bool at_end) {
    const Vec3 along = w.way(at_end ? leaf - 1 : 0);
    Station& ring =
        add_ring(w, w.position(leaf), along, w.radius(leaf), at_end ? leaf - 1 : 0, at_end ? 1 : 0);
    ring.node = w.node(leaf);
    if (const Form* form = w.form(leaf)) take_form(*form, ring);
    if (!at_end && w.kind(0) != BoneKind::tube) ring.to_next = w.kind(0);
    if (at_end) ring.lines = 0;
}

/// The rim of a dent and the rings down its wall; their places are the joint's to say.
void add_pit(PathWork& w, std::int32_t leaf, bool at_end) {
    const JointSide& side = at_end ? w.near : w.far;
    if (!side.any()) return;
    const PathEnd& end = w.n.path_end[w.path][at_end ? 0 : 1];
    const PitShape& pit = w.surfaces.pits[w.surfaces.extra[w.n.slot_first[end.joint] + end.slot]];
    const Form* form = w.form(leaf);
    for (const float width : pit_rings) {
        Station& ring = add_ring(w, pit.middle, at_end ? pit.z : Vec3(-pit.z), pit.half.x(),
                                 at_end ? leaf - 1 : 0, at_end ? 1 : 0);
        ring.node = w.node(leaf);
        ring.shape = RingShape::pit;
        ring.form_x = pit.x;
        ring.half = {pit.half.x(), pit.half.y()};
        ring.share = width;
        ring.far = !at_end;
        if (width == 1.0f && form) ring.crease = static_cast<float>(form->sharpness);
    }
}

}  // namespace

void add_end_rings(PathWork& w, bool at_end) {
    const std::int32_t leaf = at_end ? w.count() - 1 : 0;
    switch (w.s.cap[w.node(leaf)]) {
        case Cap::round:
            add_round_end(w, leaf, at_end);
            break;
        case Cap::flat:
            add_flat_end(w, leaf, at_end);
            break;
        case Cap::pit:
            add_pit(w, leaf, at_end);
            break;
        case Cap::point:
        case Cap::surface:
            break;
    }
}

}  // namespace sinew::sqm
