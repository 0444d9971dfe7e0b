#include "viewport/scene_glyphs.h"

#include <algorithm>

#include "document/images.h"
#include "document/snap.h"
#include "sinew/skeleton/graph.h"

namespace sinew::modeler {
namespace {

Colour mixed(Colour a, Colour b, double share) {
    auto mix = [&](std::uint8_t x, std::uint8_t y) { return static_cast<std::uint8_t>(x + share * (y - x)); };
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), a.a};
}

Colour with_alpha(Colour colour, int alpha) {
    colour.a = static_cast<std::uint8_t>(alpha);
    return colour;
}

Vec3f to_float(const Vec3& v) { return v.cast<float>(); }

const double selected_share = 0.22;

/// The colour of a node in the state it is in.
struct Painter {
    const Selection& selection;
    const Hit& hovered;
    GlyphColours colours;

    Colour node(const Node& node, std::int32_t i, std::int32_t image) const {
        // The type can still be told: what is selected has a ring besides (see overlay.h).
        Colour colour = colour_of(node, colours);
        if (selection.contains(i)) colour = mixed(colour, colours.selected, selected_share);
        const bool under = hovered.kind == Hit::Kind::node && hovered.index == i && hovered.image == image;
        return under ? mixed(colour, colours.hovered, 0.45) : colour;
    }
    Colour bone(const Bone& bone, std::int32_t i, std::int32_t image) const {
        const bool chosen = selection.contains(bone[0]) && selection.contains(bone[1]);
        const Colour colour = chosen ? mixed(colours.bone, colours.selected, 0.8) : colours.bone;
        const bool under = hovered.kind == Hit::Kind::bone && hovered.index == i && hovered.image == image;
        return under ? mixed(colour, colours.hovered, 0.7) : colour;
    }
};

}  // namespace

Colour colour_of(const Node& node, const GlyphColours& colours) {
    if (node.type == NodeType::negative) return colours.negative;
    if (node.parent < 0) return colours.root;
    return node.type == NodeType::sphere ? colours.node : colours.special;
}

Glyphs scene_glyphs(const Document& document, const Glyphing& glyphs, const Selection& selection,
                    const Hit& hovered, std::uint8_t alpha) {
    Glyphs scene;
    const Painter painter{selection, hovered, {}};
    const std::vector<Mat3> images = images_of(document.symmetry);
    const std::vector<Bone> bones = bones_of(document);
    for (std::int32_t k = 0; k < std::ssize(images); ++k) {
        const int shown = k == 0 ? alpha : alpha * painter.colours.ghost_alpha / 255;
        for (std::int32_t i = 0; i < std::ssize(glyphs.nodes); ++i) {
            const NodeGlyph& glyph = glyphs.nodes[i];
            const Node& node = document.nodes[i];
            if (k > 0 && is_own_twin(document.symmetry, node.position, node.radius)) continue;
            const Mat3 axes = images[k] * glyph.axes;
            scene.of(glyph.shape)
                .push_back({to_float(axes.col(0)), to_float(axes.col(1)), to_float(axes.col(2)),
                            to_float(images[k] * glyph.centre), with_alpha(painter.node(node, i, k), shown)});
        }
        for (std::int32_t i = 0; i < std::ssize(glyphs.bones); ++i) {
            const Stick& stick = glyphs.bones[i];
            scene.bones.push_back({.from = to_float(images[k] * stick.from),
                                   .from_radius = static_cast<float>(stick.from_radius),
                                   .to = to_float(images[k] * stick.to),
                                   .to_radius = static_cast<float>(stick.to_radius),
                                   .colour = with_alpha(painter.bone(bones[i], i, k), shown)});
        }
    }
    return scene;
}

std::optional<PlaneMark> mirror_plane(const Document& document) {
    if (document.symmetry.kind != Symmetry::Kind::mirror || document.nodes.empty()) return std::nullopt;
    const int axis = document.symmetry.axis;
    Eigen::AlignedBox3d box(Vec3::Zero());
    double thickest = 0;
    for (const Node& node : document.nodes) {
        Vec3 there = node.position;
        there[axis] = 0;
        box.extend(there);
        thickest = std::max(thickest, node.radius);
    }
    const Vec3 half = box.sizes() / 2 + Vec3::Constant(0.05 * box.diagonal().norm() + 1.6 * thickest);
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    PlaneMark plane;
    plane.origin = to_float(box.center());
    plane.u = static_cast<float>(half[u]) * Vec3f::Unit(u);
    plane.v = static_cast<float>(half[v]) * Vec3f::Unit(v);
    plane.tint = {72, 196, 120, 16};
    plane.line = {96, 214, 140, 100};
    return plane;
}

PlaneMark ground_plane(float reach) {
    PlaneMark plane;
    plane.u = 6 * reach * Vec3f::UnitX();
    plane.v = 6 * reach * Vec3f::UnitY();
    plane.cell = static_cast<float>(round_above(reach / 4));
    plane.line = {132, 140, 154, 84};
    plane.fade = true;
    return plane;
}

float reach_of(const Document& document) {
    double reach = 0;
    for (const Node& node : document.nodes) reach = std::max(reach, node.position.norm() + node.radius);
    return static_cast<float>(std::max(reach * 1.15, reach > 0 ? 0.0 : 1.0));
}

}  // namespace sinew::modeler
