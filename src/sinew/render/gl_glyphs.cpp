#include "sinew/render/gl_glyphs.h"

#include <epoxy/gl.h>

#include <cstddef>

#include "sinew/render/shaders.h"

namespace sinew::gl {
namespace {

void draw_batch(unsigned array, IndexRange range, int instances) {
    if (instances == 0) return;
    glBindVertexArray(array);
    glDrawElementsInstanced(GL_TRIANGLES, static_cast<int>(range.count), GL_UNSIGNED_INT,
                            reinterpret_cast<const void*>(std::size_t{range.first} * sizeof(std::uint32_t)),
                            instances);
}

/// Few glyphs are drawn finely, many coarsely: what is drawn stays within some millions of triangles.
int segments_for(std::size_t glyphs) { return glyphs <= 2000 ? 36 : glyphs <= 10000 ? 20 : 12; }

}  // namespace

Result<GlyphDrawing> GlyphDrawing::create() {
    GlyphDrawing drawing;
    struct Recipe {
        Program& program;
        std::string_view name;
        std::vector<std::string_view> vertex, fragment;
    };
    const std::vector<std::string_view> lit{frame_source, sky_source, light_source, glyph_fragment},
        depth{depth_fragment};
    const Recipe recipes[] = {
        {drawing.shape_program_, "the nodes", {frame_source, shape_vertex}, lit},
        {drawing.shape_depth_program_, "the nodes' depth", {frame_source, shape_depth_vertex}, depth},
        {drawing.bone_program_, "the bones", {frame_source, bone_source, bone_vertex}, lit},
        {drawing.bone_depth_program_,
         "the bones' depth",
         {frame_source, bone_source, bone_depth_vertex},
         depth}};
    for (const Recipe& recipe : recipes) {
        auto program = build_program(recipe.name, recipe.vertex, recipe.fragment);
        if (!program) return fail(program.error());
        recipe.program = std::move(*program);
    }
    for (Buffer* buffer :
         {&drawing.shape_vertices_, &drawing.shape_indices_, &drawing.bone_vertices_, &drawing.bone_indices_})
        *buffer = Buffer::make();
    for (Batch& batch : drawing.shapes_) drawing.join_shape(batch);
    drawing.join_bones();
    return drawing;
}

void GlyphDrawing::join_shape(Batch& batch) {
    batch.array = VertexArray::make();
    batch.instances = Buffer::make();
    glBindVertexArray(batch.array.name());
    const Attribute vertex[] = {{0, 3, GL_FLOAT, false, offsetof(TemplateVertex, position)},
                                {1, 3, GL_FLOAT, false, offsetof(TemplateVertex, normal)}};
    const Attribute instance[] = {{2, 3, GL_FLOAT, false, offsetof(ShapeGlyph, x)},
                                  {3, 3, GL_FLOAT, false, offsetof(ShapeGlyph, y)},
                                  {4, 3, GL_FLOAT, false, offsetof(ShapeGlyph, z)},
                                  {5, 3, GL_FLOAT, false, offsetof(ShapeGlyph, origin)},
                                  {6, 4, GL_UNSIGNED_BYTE, true, offsetof(ShapeGlyph, colour)}};
    set_attributes(shape_vertices_, sizeof(TemplateVertex), vertex);
    set_attributes(batch.instances, sizeof(ShapeGlyph), instance, 1);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, shape_indices_.name());
    glBindVertexArray(0);
}

void GlyphDrawing::join_bones() {
    bones_.array = VertexArray::make();
    bones_.instances = Buffer::make();
    glBindVertexArray(bones_.array.name());
    const Attribute vertex[] = {{0, 4, GL_FLOAT}};
    const Attribute instance[] = {{1, 4, GL_FLOAT, false, offsetof(BoneGlyph, from)},
                                  {2, 4, GL_FLOAT, false, offsetof(BoneGlyph, to)},
                                  {3, 4, GL_UNSIGNED_BYTE, true, offsetof(BoneGlyph, colour)},
                                  {4, 2, GL_FLOAT, false, offsetof(BoneGlyph, from_flat)}};
    set_attributes(bone_vertices_, 4 * sizeof(float), vertex);
    set_attributes(bones_.instances, sizeof(BoneGlyph), instance, 1);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, bone_indices_.name());
    glBindVertexArray(0);
}

void GlyphDrawing::make_templates(int segments) {
    if (segments == segments_) return;
    segments_ = segments;
    const ShapeTemplates shapes = shape_templates(segments);
    upload(shape_vertices_, std::span(shapes.vertices));
    upload(shape_indices_, std::span(shapes.indices));
    for (std::size_t i = 0; i < glyph_shape_count; ++i) shapes_[i].range = shapes.ranges[i];
    const BoneTemplate bones = bone_template(segments);
    upload(bone_vertices_, std::span(bones.vertices));
    upload(bone_indices_, std::span(bones.indices));
    bones_.range = {0, static_cast<std::uint32_t>(bones.indices.size())};
}

void GlyphDrawing::set(const Glyphs& glyphs) {
    std::size_t all = glyphs.bones.size();
    for (const auto& list : glyphs.shapes) all += list.size();
    make_templates(segments_for(all));
    for (std::size_t i = 0; i < glyph_shape_count; ++i) {
        upload(shapes_[i].instances, std::span(glyphs.shapes[i]));
        shapes_[i].count = static_cast<int>(glyphs.shapes[i].size());
    }
    upload(bones_.instances, std::span(glyphs.bones));
    bones_.count = static_cast<int>(glyphs.bones.size());
}

void GlyphDrawing::draw_with(const Program& shapes, const Program& bones) const {
    glUseProgram(shapes.name());
    for (const Batch& batch : shapes_) draw_batch(batch.array.name(), batch.range, batch.count);
    glUseProgram(bones.name());
    draw_batch(bones_.array.name(), bones_.range, bones_.count);
}

}  // namespace sinew::gl
