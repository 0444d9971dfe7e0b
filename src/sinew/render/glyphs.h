/// @file glyphs.h
/// The skeleton as shapes: what a node will make of the surface can be seen before it is skinned.
///
/// Shapes are drawn from a few templates, many at a time, so that ten thousand nodes are a handful of draw
/// calls. An application may fill the lists itself (ghosts, highlights); make_glyphs fills them from a
/// document.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sinew/base/vec.h"
#include "sinew/render/bounds.h"
#include "sinew/render/colour.h"
#include "sinew/skeleton/document.h"

namespace sinew {

/// Templates. sphere: radius 1 round the origin; half_sphere: its half below z = 0, closed by a disc; cone:
/// radius 1 at z = -2, tip at the origin; box: from -1 to 1 on every axis.
enum class GlyphShape : std::uint8_t { sphere, half_sphere, cone, box };
inline constexpr std::size_t glyph_shape_count = 4;

/// A template placed by the affine map p -> x p.x + y p.y + z p.z + origin.
struct ShapeGlyph {
    Vec3f x = Vec3f::UnitX(), y = Vec3f::UnitY(), z = Vec3f::UnitZ();
    Vec3f origin = Vec3f::Zero();
    Colour colour;
};
static_assert(sizeof(ShapeGlyph) == 52);

/// The hull of two spheres, or a frustum where an end is flat.
struct BoneGlyph {
    Vec3f from = Vec3f::Zero();
    float from_radius = 1;
    Vec3f to = Vec3f::Zero();
    float to_radius = 1;
    Colour colour;
    float from_flat = 0, to_flat = 0;  ///< 1: this end is cut off flat
};
static_assert(sizeof(BoneGlyph) == 44);

struct Glyphs {
    std::array<std::vector<ShapeGlyph>, glyph_shape_count> shapes;  ///< by GlyphShape
    std::vector<BoneGlyph> bones;

    std::vector<ShapeGlyph>& of(GlyphShape shape) { return shapes[static_cast<std::size_t>(shape)]; }
    const std::vector<ShapeGlyph>& of(GlyphShape shape) const {
        return shapes[static_cast<std::size_t>(shape)];
    }
    bool empty() const;
    Bounds bounds() const;
};

struct GlyphStyle {
    float bone_factor = 1;      ///< times the radii at its ends; 1: as thick as the mesh will be
    float node_factor = 1.04f;  ///< times the node's own size: it stands out of its bones
    Colour bone{176, 182, 190};
    Colour node{92, 140, 200};
    Colour root{206, 64, 56};
    Colour negative{156, 84, 176};
    Colour special{222, 152, 60};  ///< cone, hemisphere, cube and ball
};

/// Beads on thin bones: what is seen well inside a transparent mesh.
inline constexpr GlyphStyle slender_glyphs{.bone_factor = 0.16f, .node_factor = 0.32f};

/// Glyphs of all nodes and bones of a valid document, the images of its symmetry included.
Glyphs make_glyphs(const Document& document, const GlyphStyle& style = {});

}  // namespace sinew
