/// @file gl_glyphs.h
/// Glyphs in the graphics card's memory: a draw call for each shape, however many there are.
#pragma once

#include <array>

#include "sinew/render/gl_object.h"
#include "sinew/render/glyph_templates.h"

namespace sinew::gl {

class GlyphDrawing {
  public:
    static Result<GlyphDrawing> create();
    void set(const Glyphs& glyphs);
    void draw() const { draw_with(shape_program_, bone_program_); }
    void draw_depth() const { draw_with(shape_depth_program_, bone_depth_program_); }

  private:
    /// Instances of one template, with the vertex array that joins them to it.
    struct Batch {
        VertexArray array;
        Buffer instances;
        IndexRange range;
        int count = 0;
    };
    void make_templates(int segments);
    void join_shape(Batch& batch);
    void join_bones();
    void draw_with(const Program& shapes, const Program& bones) const;

    Program shape_program_, shape_depth_program_, bone_program_, bone_depth_program_;
    Buffer shape_vertices_, shape_indices_, bone_vertices_, bone_indices_;
    std::array<Batch, glyph_shape_count> shapes_;
    Batch bones_;
    int segments_ = 0;
};

}  // namespace sinew::gl
