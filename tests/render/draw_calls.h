/// @file draw_calls.h
/// How often something draws: counts the draw calls of OpenGL while it lives.
///
/// epoxy calls OpenGL through pointers, which are looked up at the first use: draw once before counting.
#pragma once

#include <epoxy/gl.h>

namespace sinew {

class DrawCalls {
  public:
    DrawCalls() {
        count = 0;
        arrays_ = epoxy_glDrawArrays;
        elements_ = epoxy_glDrawElements;
        instanced_arrays_ = epoxy_glDrawArraysInstanced;
        instanced_elements_ = epoxy_glDrawElementsInstanced;
        real() = this;
        epoxy_glDrawArrays = [](GLenum mode, GLint first, GLsizei n) {
            ++count;
            real()->arrays_(mode, first, n);
        };
        epoxy_glDrawElements = [](GLenum mode, GLsizei n, GLenum type, const void* at) {
            ++count;
            real()->elements_(mode, n, type, at);
        };
        epoxy_glDrawArraysInstanced = [](GLenum mode, GLint first, GLsizei n, GLsizei instances) {
            ++count;
            real()->instanced_arrays_(mode, first, n, instances);
        };
        epoxy_glDrawElementsInstanced = [](GLenum mode, GLsizei n, GLenum type, const void* at,
                                           GLsizei instances) {
            ++count;
            real()->instanced_elements_(mode, n, type, at, instances);
        };
    }
    ~DrawCalls() {
        epoxy_glDrawArrays = arrays_;
        epoxy_glDrawElements = elements_;
        epoxy_glDrawArraysInstanced = instanced_arrays_;
        epoxy_glDrawElementsInstanced = instanced_elements_;
    }
    DrawCalls(const DrawCalls&) = delete;

    static inline int count = 0;

  private:
    static DrawCalls*& real() {
        static DrawCalls* now = nullptr;
        return now;
    }
    PFNGLDRAWARRAYSPROC arrays_;
    PFNGLDRAWELEMENTSPROC elements_;
    PFNGLDRAWARRAYSINSTANCEDPROC instanced_arrays_;
    PFNGLDRAWELEMENTSINSTANCEDPROC instanced_elements_;
};

}  // namespace sinew
