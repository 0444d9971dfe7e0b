#include "sinew/render/gl_overlay.h"

#include <epoxy/gl.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sinew/render/shaders.h"

namespace sinew::gl {
namespace {

MarkBatch make_batch(std::size_t stride, std::span<const Attribute> attributes, unsigned divisor) {
    MarkBatch batch{VertexArray::make(), Buffer::make()};
    glBindVertexArray(batch.array.name());
    set_attributes(batch.instances, stride, attributes, divisor);
    glBindVertexArray(0);
    return batch;
}

constexpr int ground_cells = 128;  ///< along a side; the vertex shader knows it too

/// The places of the vertices are the shader's.
std::vector<std::uint32_t> ground_triangles() {
    std::vector<std::uint32_t> triangles;
    constexpr std::uint32_t row = ground_cells + 1;
    for (std::uint32_t y = 0; y < ground_cells; ++y)
        for (std::uint32_t x = 0; x < ground_cells; ++x) {
            const std::uint32_t a = y * row + x, b = a + 1, c = b + row, d = a + row;
            triangles.insert(triangles.end(), {a, b, c, a, c, d});
        }
    return triangles;
}

void draw_strips(const Program& program, const MarkBatch& batch) {
    if (batch.count == 0) return;
    glUseProgram(program.name());
    glBindVertexArray(batch.array.name());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, batch.count);
}

}  // namespace

Result<OverlayDrawing> OverlayDrawing::create() {
    OverlayDrawing drawing;
    struct Recipe {
        Program& program;
        std::string_view name;
        std::vector<std::string_view> vertex, fragment;
    };
    const Recipe recipes[] = {
        {drawing.point_program_, "points", {frame_source, nearer_source, point_vertex}, {point_fragment}},
        {drawing.line_program_, "lines", {frame_source, nearer_source, line_vertex}, {line_fragment}},
        {drawing.plane_program_, "planes", {frame_source, plane_vertex}, {plane_fragment}},
        {drawing.ground_program_,
         "the ground",
         {frame_source, sky_source, ground_vertex},
         {frame_source, ground_fragment}}};
    for (const Recipe& recipe : recipes) {
        auto program = build_program(recipe.name, recipe.vertex, recipe.fragment);
        if (!program) return fail(program.error());
        recipe.program = std::move(*program);
    }
    drawing.ground_array_ = VertexArray::make();
    drawing.ground_indices_ = Buffer::make();
    upload(drawing.ground_indices_, std::span<const std::uint32_t>(ground_triangles()));
    glBindVertexArray(drawing.ground_array_.name());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, drawing.ground_indices_.name());
    glBindVertexArray(0);
    return drawing;
}

MarkBatch OverlayDrawing::make_points() const {
    const Attribute attributes[] = {{0, 3, GL_FLOAT, false, offsetof(PointMark, position)},
                                    {1, 1, GL_FLOAT, false, offsetof(PointMark, size)},
                                    {2, 4, GL_UNSIGNED_BYTE, true, offsetof(PointMark, colour)}};
    return make_batch(sizeof(PointMark), attributes, 0);
}

MarkBatch OverlayDrawing::make_lines() const {
    const Attribute attributes[] = {{0, 3, GL_FLOAT, false, offsetof(LineMark, from)},
                                    {1, 3, GL_FLOAT, false, offsetof(LineMark, to)},
                                    {2, 1, GL_FLOAT, false, offsetof(LineMark, width)},
                                    {3, 4, GL_UNSIGNED_BYTE, true, offsetof(LineMark, colour)}};
    return make_batch(sizeof(LineMark), attributes, 1);
}

MarkBatch OverlayDrawing::make_planes() const {
    const Attribute attributes[] = {{0, 3, GL_FLOAT, false, offsetof(PlaneMark, origin)},
                                    {1, 3, GL_FLOAT, false, offsetof(PlaneMark, u)},
                                    {2, 3, GL_FLOAT, false, offsetof(PlaneMark, v)},
                                    {3, 1, GL_FLOAT, false, offsetof(PlaneMark, cell)},
                                    {4, 4, GL_UNSIGNED_BYTE, true, offsetof(PlaneMark, tint)},
                                    {5, 4, GL_UNSIGNED_BYTE, true, offsetof(PlaneMark, line)},
                                    {6, 1, GL_UNSIGNED_BYTE, false, offsetof(PlaneMark, fade)}};
    return make_batch(sizeof(PlaneMark), attributes, 1);
}

void OverlayDrawing::draw_points(const MarkBatch& points) const {
    if (points.count == 0) return;
    glUseProgram(point_program_.name());
    glBindVertexArray(points.array.name());
    glDrawArrays(GL_POINTS, 0, points.count);
}

void OverlayDrawing::draw_lines(const MarkBatch& lines) const { draw_strips(line_program_, lines); }
void OverlayDrawing::draw_planes(const MarkBatch& planes) const { draw_strips(plane_program_, planes); }

void OverlayDrawing::draw_ground() const {
    glUseProgram(ground_program_.name());
    glBindVertexArray(ground_array_.name());
    glDrawElements(GL_TRIANGLES, 6 * ground_cells * ground_cells, GL_UNSIGNED_INT, nullptr);
}

}  // namespace sinew::gl
