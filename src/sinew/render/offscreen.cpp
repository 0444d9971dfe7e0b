#include "sinew/render/offscreen.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace sinew {
namespace {

constexpr int sample_count = 4;

void attach(const gl::Renderbuffer& buffer, unsigned point, unsigned format, int samples, int width,
            int height) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, buffer.name());
}

bool complete() { return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE; }

int largest_size() {
    int viewport[2]{}, buffer = 0;
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &buffer);
    return std::min({viewport[0], viewport[1], buffer});
}

Colour straight(Colour premultiplied) {
    const int a = premultiplied.a;
    if (a == 255) return premultiplied;
    if (a == 0) return {0, 0, 0, 0};
    const auto divide = [a](int x) {
        return static_cast<std::uint8_t>(std::min(255, (x * 255 + a / 2) / a));
    };
    return {divide(premultiplied.r), divide(premultiplied.g), divide(premultiplied.b), premultiplied.a};
}

}  // namespace

Result<Offscreen> Offscreen::create(int width, int height) {
    const int largest = largest_size();
    if (width < 1 || height < 1 || width > largest || height > largest)
        return fail(ErrorKind::call,
                    "a picture of " + std::to_string(width) + "x" + std::to_string(height) +
                        " pixels cannot be drawn",
                    "take from 1x1 to " + std::to_string(largest) + "x" + std::to_string(largest));
    Offscreen target;
    target.width_ = width;
    target.height_ = height;
    target.samples_ = gl::Framebuffer::make();
    target.resolved_ = gl::Framebuffer::make();
    for (gl::Renderbuffer* buffer : {&target.sample_colour_, &target.sample_depth_, &target.resolved_colour_})
        *buffer = gl::Renderbuffer::make();
    glBindFramebuffer(GL_FRAMEBUFFER, target.resolved_.name());
    attach(target.resolved_colour_, GL_COLOR_ATTACHMENT0, GL_RGBA8, 0, width, height);
    bool good = complete();
    glBindFramebuffer(GL_FRAMEBUFFER, target.samples_.name());
    attach(target.sample_colour_, GL_COLOR_ATTACHMENT0, GL_RGBA8, sample_count, width, height);
    attach(target.sample_depth_, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, sample_count, width, height);
    good = good && complete() && glGetError() == GL_NO_ERROR;
    if (!good) return fail(ErrorKind::program, "the graphics driver has no framebuffer of that size");
    return target;
}

void Offscreen::begin(Colour background) const {
    glBindFramebuffer(GL_FRAMEBUFFER, samples_.name());
    glViewport(0, 0, width_, height_);
    const float a = static_cast<float>(background.a) / 255;
    glClearColor(a * static_cast<float>(background.r) / 255, a * static_cast<float>(background.g) / 255,
                 a * static_cast<float>(background.b) / 255, a);
    glDepthMask(GL_TRUE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

Picture Offscreen::read() const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, samples_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.name());
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.name());
    Picture upside_down(width_, height_), picture(width_, height_);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.pixels.data());
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) picture.at(x, y) = straight(upside_down.at(x, height_ - 1 - y));
    return picture;
}

}  // namespace sinew
