/// @file gl_object.h
/// OpenGL objects with an owner. All of this needs a current OpenGL 3.3 core context, when they go too.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "sinew/base/result.h"

namespace sinew::gl {

enum class Kind { buffer, vertex_array, texture, framebuffer, renderbuffer, program };
unsigned make(Kind kind);
void remove(Kind kind, unsigned name);

/// Owns the name of one object; moves, does not copy. 0: none.
template <Kind kind>
class Object {
  public:
    Object() = default;
    explicit Object(unsigned name) : name_(name) {}
    static Object make() { return Object(gl::make(kind)); }
    Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Object& operator=(Object&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~Object() {
        if (name_) gl::remove(kind, name_);
    }
    unsigned name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }

  private:
    unsigned name_ = 0;
};

using Buffer = Object<Kind::buffer>;
using VertexArray = Object<Kind::vertex_array>;
using Texture = Object<Kind::texture>;
using Framebuffer = Object<Kind::framebuffer>;
using Renderbuffer = Object<Kind::renderbuffer>;
using Program = Object<Kind::program>;

/// Compiles and links; both stages are lists of source pieces put after `#version 330 core`. The uniform
/// block `Frame` is bound to binding 0, `Sky` to 1, the sampler `sky_depth` to texture unit 0. Fails with the
/// driver's log (kind program).
Result<Program> build_program(std::string_view name, std::span<const std::string_view> vertex,
                              std::span<const std::string_view> fragment);

/// Replaces the whole content of a buffer.
void upload(const Buffer& buffer, const void* data, std::size_t bytes);
template <class T>
void upload(const Buffer& buffer, std::span<const T> items) {
    upload(buffer, items.data(), items.size_bytes());
}

/// One attribute of the bound vertex array, read from a buffer.
struct Attribute {
    unsigned location;
    int components;
    unsigned type;            ///< GL_FLOAT ...
    bool normalized = false;  ///< integers become 0..1 or -1..1
    std::size_t offset = 0;   ///< bytes
};
/// @param divisor  0: an entry a vertex, 1: an entry an instance
void set_attributes(const Buffer& buffer, std::size_t stride, std::span<const Attribute> attributes,
                    unsigned divisor = 0);

}  // namespace sinew::gl
