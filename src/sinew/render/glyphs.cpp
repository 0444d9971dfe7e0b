#include "sinew/render/glyphs.h"

#include <algorithm>

#include "sinew/skeleton/frames.h"
#include "sinew/skeleton/graph.h"
#include "sinew/skeleton/symmetry.h"

namespace sinew {
namespace {

/// All that the glyph of one node is made from.
struct NodeView {
    const Node& node;
    bool leaf;
    Vec3 outward;  ///< of a leaf: away from its only neighbour; zero at other nodes
    Mat3 frame;
};

NodeView view_of(const Document& document, const std::vector<Bone>& bones, const Adjacency& neighbours,
                 std::int32_t i) {
    const Node& node = document.nodes[i];
    NodeView view{node, neighbours.degree(i) == 1, Vec3::Zero(), local_frame(document, bones, neighbours, i)};
    if (!view.leaf) return view;
    const Bone& bone = bones[neighbours.bones(i)[0]];
    view.outward =
        (node.position - document.nodes[bone[0] == i ? bone[1] : bone[0]].position).stableNormalized();
    return view;
}

Colour colour_of(const Node& node, const GlyphStyle& style) {
    if (node.type == NodeType::negative) return style.negative;
    if (node.parent < 0) return style.root;
    return node.type == NodeType::sphere ? style.node : style.special;
}

GlyphShape shape_of(const NodeView& view) {
    const Node& node = view.node;
    if (node.type == NodeType::cube) return GlyphShape::box;
    if (view.leaf && node.type == NodeType::cone) return GlyphShape::cone;
    if (view.leaf && node.type == NodeType::hemisphere) return GlyphShape::half_sphere;
    return node.section == Section::rectangular && node.type == NodeType::sphere ? GlyphShape::box
                                                                                 : GlyphShape::sphere;
}

/// Half extents along the local axes.
Vec3 half_extents(const NodeView& view) {
    const Node& node = view.node;
    if (node.type == NodeType::cube) return node.size ? Vec3(*node.size / 2) : Vec3::Constant(node.radius);
    const bool whole = node.type == NodeType::ball || (view.node.parent < 0 && view.outward.isZero());
    return node.radius * Vec3(node.scale[0], node.scale[1], whole ? node.scale[2] : 1);
}

ShapeGlyph glyph_of(const NodeView& view, const GlyphStyle& style) {
    const GlyphShape shape = shape_of(view);
    const bool pointed = shape == GlyphShape::cone || shape == GlyphShape::half_sphere;
    Mat3 frame = view.frame;
    if (pointed && view.node.parent < 0)
        frame.rightCols<2>() *= -1;  // z leads away from a root, tips outward
    const Vec3 half = half_extents(view) * double(style.node_factor);
    const Eigen::Matrix3f axes = (frame * half.asDiagonal()).cast<float>();
    Vec3f origin = view.node.position.cast<float>();
    if (shape == GlyphShape::half_sphere) origin += 0.02f * axes.col(2);  // its disc lies on the bone's
    return {axes.col(0), axes.col(1), axes.col(2), origin, colour_of(view.node, style)};
}

/// Radius of the tube that a bone has at this node.
float tube_radius(const Node& node, bool leaf) {
    return leaf && node.type == NodeType::cone ? 0.f : static_cast<float>(node.radius);
}

}  // namespace

bool Glyphs::empty() const {
    return bones.empty() &&
           std::all_of(shapes.begin(), shapes.end(), [](const auto& list) { return list.empty(); });
}

Bounds Glyphs::bounds() const {
    Bounds box;
    const auto add = [&](const Vec3f& centre, const Vec3f& half) {
        box.extend(centre - half), box.extend(centre + half);
    };
    for (const auto& list : shapes)
        for (const ShapeGlyph& g : list) add(g.origin, g.x.cwiseAbs() + g.y.cwiseAbs() + g.z.cwiseAbs());
    for (const BoneGlyph& b : bones) {
        add(b.from, Vec3f::Constant(b.from_radius));
        add(b.to, Vec3f::Constant(b.to_radius));
    }
    return box;
}

Glyphs make_glyphs(const Document& document, const GlyphStyle& style) {
    if (document.symmetry.kind != Symmetry::Kind::none) {
        Document expanded = expand_symmetry(document).document;
        expanded.symmetry = {};
        return make_glyphs(expanded, style);
    }
    const std::vector<Bone> bones = bones_of(document);
    const auto node_count = static_cast<std::int32_t>(document.nodes.size());
    const Adjacency neighbours = adjacency(node_count, bones);
    Glyphs glyphs;
    for (std::int32_t i = 0; i < node_count; ++i) {
        const NodeView view = view_of(document, bones, neighbours, i);
        const bool is_tip = view.leaf && view.node.type == NodeType::cone && style.bone_factor == 1;
        if (!is_tip)
            glyphs.of(shape_of(view)).push_back(glyph_of(view, style));  // at full size the bone is the cone
    }
    for (const Bone& bone : bones) {
        const Node &a = document.nodes[bone[0]], &b = document.nodes[bone[1]];
        const bool leaf_a = neighbours.degree(bone[0]) == 1, leaf_b = neighbours.degree(bone[1]) == 1;
        glyphs.bones.push_back({.from = a.position.cast<float>(),
                                .from_radius = style.bone_factor * tube_radius(a, leaf_a),
                                .to = b.position.cast<float>(),
                                .to_radius = style.bone_factor * tube_radius(b, leaf_b),
                                .colour = style.bone,
                                .from_flat = leaf_a && a.type == NodeType::hemisphere ? 1.f : 0.f,
                                .to_flat = leaf_b && b.type == NodeType::hemisphere ? 1.f : 0.f});
    }
    return glyphs;
}

}  // namespace sinew
