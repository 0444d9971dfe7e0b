/// @file gl_scene.h
/// Draws a scene with OpenGL 3.3 core, into whatever framebuffer is bound: a window's, Qt's, or one in
/// memory.
///
/// Everything here needs the same current context, the destructor too.
#pragma once

#include <memory>
#include <span>

#include "sinew/base/result.h"
#include "sinew/render/camera.h"
#include "sinew/render/glyphs.h"
#include "sinew/render/mesh_buffers.h"
#include "sinew/render/overlay.h"

namespace sinew {

/// lit: three soft lights, smooth normals. matcap: form and nothing else. flat: as lit, every face on its
/// own.
enum class Shading : std::uint8_t { lit, matcap, flat };

/// Lights hang on the camera, so that every view is lit alike. Directions towards the light in eye space (x
/// right, y up, z to the eye), of any length but zero; strengths from 0.
struct Lights {
    Vec3f key{-0.45f, 0.62f, 0.64f};
    float key_strength = 0.95f;
    Vec3f fill{0.80f, 0.05f, 0.60f};
    float fill_strength = 0.16f;
    Vec3f rim{0.35f, 0.45f, -0.82f};
    float rim_strength = 0.55f;
};

struct DrawOptions {
    Shading shading = Shading::lit;
    bool mesh = true;                   ///< the surface
    Colour mesh_colour{222, 198, 178};  ///< warm clay
    float opacity = 1;                  ///< below 1 the glyphs inside are seen through the nearest surface
    bool wire = false;                  ///< the edges of the faces
    float wire_width = 1.2f;            ///< pixels, whatever the distance
    Colour wire_colour{38, 40, 48, 215};
    bool glyphs = true;
    bool irregular = false;  ///< marks vertices of a valence other than 4
    bool creases = false;    ///< marks crease edges
    bool marks = true;       ///< the lines, points and planes that the application has set
    Lights lights;

    /// Soft shadows in the scene and on a ground below it. They are drawn anew when the scene or the camera
    /// has changed: for pictures, or while a viewport rests.
    bool shadows = false;
    float ground_shadow = 0.5f;  ///< how dark it gets, 0 (no ground) to 1; needs `shadows`
};

class GlScene {
  public:
    /// Fails (kind program) where the context is not at least OpenGL 3.3, or the driver refuses a shader.
    static Result<GlScene> create();
    GlScene(GlScene&&) noexcept;
    GlScene& operator=(GlScene&&) noexcept;
    ~GlScene();

    // What is drawn until it is set again; nothing at first.
    void set_mesh(const MeshBuffers& mesh);
    void set_glyphs(const Glyphs& glyphs);
    void set_lines(std::span<const LineMark> lines);
    void set_points(std::span<const PointMark> points);
    void set_planes(std::span<const PlaneMark> planes);  ///< drawn in this order, after the solid things

    /// Draws into the viewport (0, 0, width, height), pixels, of the framebuffer that is bound. That has a
    /// depth buffer; clear both before. What is written is premultiplied by its alpha. Afterwards no program,
    /// no vertex array and no buffer is bound; depth test, blending and culling are off.
    void draw(const Camera& camera, int width, int height, const DrawOptions& options = {});

    Bounds bounds() const;  ///< of mesh and glyphs

  private:
    struct State;
    explicit GlScene(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace sinew
