#include "sinew/render/gl_object.h"

#include <epoxy/gl.h>

#include <vector>

namespace sinew::gl {
namespace {

std::string log_of(unsigned shader) {
    int length = 0;
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(length, '\0');
    glGetShaderInfoLog(shader, length, nullptr, log.data());
    return log;
}

/// A shader lives only until its program is linked.
Result<unsigned> compile(unsigned stage, std::string_view name, std::span<const std::string_view> pieces) {
    std::vector<const char*> texts{"#version 330 core\n"};
    std::vector<int> lengths{-1};
    for (const std::string_view piece : pieces) {
        texts.push_back(piece.data());
        lengths.push_back(static_cast<int>(piece.size()));
    }
    const unsigned shader = glCreateShader(stage);
    glShaderSource(shader, static_cast<int>(texts.size()), texts.data(), lengths.data());
    glCompileShader(shader);
    int compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled) return shader;
    Error error{.kind = ErrorKind::program, .message = "shader " + std::string(name) + ": " + log_of(shader)};
    glDeleteShader(shader);
    return fail(std::move(error));
}

void bind_block(unsigned program, const char* block, unsigned binding) {
    const unsigned index = glGetUniformBlockIndex(program, block);
    if (index != GL_INVALID_INDEX) glUniformBlockBinding(program, index, binding);
}

Result<Program> link(std::string_view name, unsigned vertex, unsigned fragment) {
    Program program = Program::make();
    for (const unsigned shader : {vertex, fragment}) glAttachShader(program.name(), shader);
    glLinkProgram(program.name());
    for (const unsigned shader : {vertex, fragment}) glDetachShader(program.name(), shader);
    int linked = 0;
    glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (!linked) return fail(ErrorKind::program, "the shaders of " + std::string(name) + " do not link");
    bind_block(program.name(), "Frame", 0);
    bind_block(program.name(), "Sky", 1);
    glUseProgram(program.name());
    if (const int sampler = glGetUniformLocation(program.name(), "sky_depth"); sampler >= 0)
        glUniform1i(sampler, 0);
    glUseProgram(0);
    return program;
}

}  // namespace

unsigned make(Kind kind) {
    unsigned name = 0;
    switch (kind) {
        case Kind::buffer:
            glGenBuffers(1, &name);
            break;
        case Kind::vertex_array:
            glGenVertexArrays(1, &name);
            break;
        case Kind::texture:
            glGenTextures(1, &name);
            break;
        case Kind::framebuffer:
            glGenFramebuffers(1, &name);
            break;
        case Kind::renderbuffer:
            glGenRenderbuffers(1, &name);
            break;
        case Kind::program:
            name = glCreateProgram();
            break;
    }
    return name;
}

void remove(Kind kind, unsigned name) {
    switch (kind) {
        case Kind::buffer:
            glDeleteBuffers(1, &name);
            break;
        case Kind::vertex_array:
            glDeleteVertexArrays(1, &name);
            break;
        case Kind::texture:
            glDeleteTextures(1, &name);
            break;
        case Kind::framebuffer:
            glDeleteFramebuffers(1, &name);
            break;
        case Kind::renderbuffer:
            glDeleteRenderbuffers(1, &name);
            break;
        case Kind::program:
            glDeleteProgram(name);
            break;
    }
}

Result<Program> build_program(std::string_view name, std::span<const std::string_view> vertex,
                              std::span<const std::string_view> fragment) {
    auto vertex_shader = compile(GL_VERTEX_SHADER, name, vertex);
    if (!vertex_shader) return fail(vertex_shader.error());
    auto fragment_shader = compile(GL_FRAGMENT_SHADER, name, fragment);
    if (!fragment_shader) {
        glDeleteShader(*vertex_shader);
        return fail(fragment_shader.error());
    }
    auto program = link(name, *vertex_shader, *fragment_shader);
    glDeleteShader(*vertex_shader);
    glDeleteShader(*fragment_shader);
    return program;
}

void upload(const Buffer& buffer, const void* data, std::size_t bytes) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STREAM_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void set_attributes(const Buffer& buffer, std::size_t stride, std::span<const Attribute> attributes,
                    unsigned divisor) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    for (const Attribute& a : attributes) {
        glEnableVertexAttribArray(a.location);
        glVertexAttribPointer(a.location, a.components, a.type, a.normalized, static_cast<int>(stride),
                              reinterpret_cast<const void*>(a.offset));  // NOLINT(performance-no-int-to-ptr)
        glVertexAttribDivisor(a.location, divisor);
    }
    glBindBuffer(GL_ARRAY_BUFFER, 0);
}

}  // namespace sinew::gl
