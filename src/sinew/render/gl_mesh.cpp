#include "sinew/render/gl_mesh.h"

#include <epoxy/gl.h>

#include <cstddef>

#include "sinew/render/shaders.h"

namespace sinew::gl {

Result<MeshDrawing> MeshDrawing::create() {
    const std::string_view vertex[] = {frame_source, mesh_vertex};
    const std::string_view fragment[] = {frame_source, sky_source, light_source, mesh_fragment};
    const std::string_view depth_vertex[] = {frame_source, mesh_depth_vertex}, depth[] = {depth_fragment};
    auto program = build_program("the mesh", vertex, fragment);
    if (!program) return fail(program.error());
    auto depth_program = build_program("the mesh's depth", depth_vertex, depth);
    if (!depth_program) return fail(depth_program.error());

    MeshDrawing drawing;
    drawing.program_ = std::move(*program);
    drawing.depth_program_ = std::move(*depth_program);
    drawing.array_ = VertexArray::make();
    drawing.vertices_ = Buffer::make();
    drawing.indices_ = Buffer::make();
    glBindVertexArray(drawing.array_.name());
    const Attribute attributes[] = {{0, 3, GL_FLOAT, false, offsetof(MeshVertex, position)},
                                    {1, 4, GL_INT_2_10_10_10_REV, true, offsetof(MeshVertex, normal)},
                                    {2, 4, GL_INT_2_10_10_10_REV, true, offsetof(MeshVertex, face_normal)},
                                    {3, 2, GL_UNSIGNED_BYTE, true, offsetof(MeshVertex, u)},
                                    {4, 1, GL_UNSIGNED_BYTE, false, offsetof(MeshVertex, part)}};
    set_attributes(drawing.vertices_, sizeof(MeshVertex), attributes);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, drawing.indices_.name());
    glBindVertexArray(0);
    return drawing;
}

void MeshDrawing::set(const MeshBuffers& mesh) {
    upload(vertices_, std::span(mesh.vertices));
    upload(indices_, std::span(mesh.triangles));
    index_count_ = static_cast<int>(mesh.triangles.size());
}

void MeshDrawing::draw() const {
    if (empty()) return;
    glUseProgram(program_.name());
    glBindVertexArray(array_.name());
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

void MeshDrawing::draw_depth() const {
    if (empty()) return;
    glUseProgram(depth_program_.name());
    glBindVertexArray(array_.name());
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

}  // namespace sinew::gl
