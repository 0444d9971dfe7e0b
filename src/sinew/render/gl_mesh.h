/// @file gl_mesh.h
/// The mesh in the graphics card's memory: one buffer, one draw call.
#pragma once

#include "sinew/render/gl_object.h"
#include "sinew/render/mesh_buffers.h"

namespace sinew::gl {

class MeshDrawing {
  public:
    static Result<MeshDrawing> create();
    void set(const MeshBuffers& mesh);
    void draw() const;
    void draw_depth() const;  ///< into a map of the sky
    bool empty() const { return index_count_ == 0; }

  private:
    Program program_, depth_program_;
    VertexArray array_;
    Buffer vertices_, indices_;
    int index_count_ = 0;
};

}  // namespace sinew::gl
