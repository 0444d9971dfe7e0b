/// @file egl_context.h
/// An OpenGL 3.3 core context without a window, a display or a server: EGL's surfaceless platform, with Mesa
/// in software where there is no graphics card.
#pragma once

#include <memory>

#include "sinew/base/result.h"

namespace sinew {

class EglContext {
  public:
    /// Makes a context and makes it current on this thread. Fails (kind program) where libEGL or a driver is
    /// missing, and says which Debian packages to install.
    /// @param library  file name of EGL's loader: another one to see what happens without it
    static Result<EglContext> create(const char* library = "libEGL.so.1");
    EglContext(EglContext&&) noexcept;
    EglContext& operator=(EglContext&&) noexcept;
    ~EglContext();

    void make_current() const;  ///< again, after another one was

  private:
    struct State;
    explicit EglContext(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace sinew
