/// @file gl_overlay.h
/// Points, lines and planes in the graphics card's memory: one draw call for each kind.
#pragma once

#include <span>

#include "sinew/render/gl_object.h"
#include "sinew/render/overlay.h"

namespace sinew::gl {

/// Instances of one kind of mark, each a strip of four vertices, or a point.
struct MarkBatch {
    VertexArray array;
    Buffer instances;
    int count = 0;
};

class OverlayDrawing {
  public:
    static Result<OverlayDrawing> create();

    MarkBatch make_points() const;
    MarkBatch make_lines() const;
    MarkBatch make_planes() const;

    void draw_points(const MarkBatch& points) const;
    void draw_lines(const MarkBatch& lines) const;
    void draw_planes(const MarkBatch& planes) const;
    void draw_ground() const;  ///< the shadow on the plane z = FrameBlock::style.z

  private:
    Program point_program_, line_program_, plane_program_, ground_program_;
    VertexArray ground_array_;
    Buffer ground_indices_;
};

template <class Mark>
void set_marks(MarkBatch& batch, std::span<const Mark> marks) {
    upload(batch.instances, marks);
    batch.count = static_cast<int>(marks.size());
}

}  // namespace sinew::gl
