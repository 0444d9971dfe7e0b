#include "sinew/render/egl_context.h"

#include <dlfcn.h>
#include <epoxy/egl.h>

namespace sinew {
namespace {

const char* const cure = "install it: apt-get install libegl1 libgl1 libgl1-mesa-dri";

tl::unexpected<Error> missing(std::string what) { return fail(ErrorKind::program, std::move(what), cure); }

/// epoxy ends the program when it cannot open a library: so look before it does.
bool can_open(const char* library) {
    void* handle = dlopen(library, RTLD_LAZY | RTLD_LOCAL);
    if (handle) dlclose(handle);
    return handle != nullptr;
}

EGLDisplay surfaceless_display() {
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless") &&
        epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base"))
        return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    return eglGetDisplay(EGL_DEFAULT_DISPLAY);
}

EGLContext core_context(EGLDisplay display) {
    if (!eglBindAPI(EGL_OPENGL_API)) return EGL_NO_CONTEXT;
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0) return EGL_NO_CONTEXT;
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 3,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 3,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    return eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
}

}  // namespace

/// The display is shared by the process and stays open: closing it would close it for others.
struct EglContext::State {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    ~State() {
        if (context == EGL_NO_CONTEXT) return;
        if (eglGetCurrentContext() == context)
            eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display, context);
    }
};

Result<EglContext> EglContext::create(const char* library) {
    if (!can_open(library))
        return missing("drawing without a window needs EGL, and " + std::string(library) + " is not there");
    if (!can_open("libOpenGL.so.0") && !can_open("libGL.so.1"))
        return missing("drawing needs OpenGL, and libGL.so.1 is not there");
    auto state = std::make_unique<State>();
    state->display = surfaceless_display();
    if (state->display == EGL_NO_DISPLAY || !eglInitialize(state->display, nullptr, nullptr))
        return missing("EGL finds no device to draw with");
    state->context = core_context(state->display);
    if (state->context == EGL_NO_CONTEXT) return missing("no driver here offers OpenGL 3.3 core");
    if (!eglMakeCurrent(state->display, EGL_NO_SURFACE, EGL_NO_SURFACE, state->context))
        return missing("the driver cannot draw without a window");
    return EglContext(std::move(state));
}

EglContext::EglContext(std::unique_ptr<State> state) : state_(std::move(state)) {}
EglContext::EglContext(EglContext&&) noexcept = default;
EglContext& EglContext::operator=(EglContext&&) noexcept = default;
EglContext::~EglContext() = default;

void EglContext::make_current() const {
    eglMakeCurrent(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, state_->context);
}

}  // namespace sinew
