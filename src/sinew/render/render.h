/// @file render.h
/// A scene in, a picture out, with no window and no display.
#pragma once

#include <optional>
#include <vector>

#include "sinew/base/result.h"
#include "sinew/render/gl_scene.h"
#include "sinew/render/picture.h"

namespace sinew {

/// What is to be seen: any part may be empty. mesh_buffers() and make_glyphs() fill it.
struct Scene {
    MeshBuffers mesh;
    Glyphs glyphs;
    std::vector<LineMark> lines;
    std::vector<PointMark> points;
    std::vector<PlaneMark> planes;
};

inline constexpr Colour light_grey{238, 239, 241, 255};
inline constexpr Colour transparent{0, 0, 0, 0};

struct RenderOptions {
    int width = 1280, height = 960;
    View view = View::iso;
    std::optional<Camera> camera;  ///< instead of the view, as it is; else the view is fitted to the scene
    double margin = 0.08;          ///< share left free on each side when it is fitted
    Colour background = light_grey;
    DrawOptions draw{.shadows = true};
};

/// Fails (kind program) where there is no EGL, (kind call) for an impossible size. The same scene gives the
/// same picture, bit by bit, on the same driver. Each call makes a context of its own and lets it go, and
/// leaves none current on this thread.
Result<Picture> render(const Scene& scene, const RenderOptions& options = {});

/// A renderer that keeps its context, for many pictures in a row.
class Renderer {
  public:
    static Result<Renderer> create();
    Result<Picture> render(const Scene& scene, const RenderOptions& options = {});
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

  private:
    struct State;
    explicit Renderer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// The camera that a picture is taken with.
Camera camera_for(const Scene& scene, const RenderOptions& options);

}  // namespace sinew
