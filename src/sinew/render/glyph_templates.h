/// @file glyph_templates.h
/// The unit shapes that glyphs are drawn from, and how finely.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sinew/render/glyphs.h"

namespace sinew::gl {

struct TemplateVertex {
    float position[3];
    float normal[3];
};

/// A run of triangles in a shared index buffer.
struct IndexRange {
    std::uint32_t first = 0, count = 0;
};

struct ShapeTemplates {
    std::vector<TemplateVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::array<IndexRange, glyph_shape_count> ranges;  ///< by GlyphShape
};

/// @param segments  round the shapes, >= 3
ShapeTemplates shape_templates(int segments);

/// A bone's grid: cosine and sine of the turn, the part (0 ball, 1 cone, 2 ball) and the place along it, 0
/// to 1.
struct BoneTemplate {
    std::vector<std::array<float, 4>> vertices;
    std::vector<std::uint32_t> indices;
};
BoneTemplate bone_template(int segments);

}  // namespace sinew::gl
