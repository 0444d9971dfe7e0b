/// @file offscreen.h
/// A framebuffer in memory with four samples a pixel, and its picture.
#pragma once

#include "sinew/render/gl_object.h"
#include "sinew/render/picture.h"

namespace sinew {

class Offscreen {
  public:
    /// Fails (kind call) for a size that is not positive or more than the driver can draw.
    static Result<Offscreen> create(int width, int height);

    /// Binds it and clears it to a colour, and the depth.
    void begin(Colour background) const;
    /// Resolves the samples and reads the picture; what was drawn is taken as premultiplied.
    Picture read() const;

  private:
    int width_ = 0, height_ = 0;
    gl::Framebuffer samples_, resolved_;
    gl::Renderbuffer sample_colour_, sample_depth_, resolved_colour_;
};

}  // namespace sinew
