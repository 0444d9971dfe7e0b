#include "sinew/render/gl_scene.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

#include "sinew/render/frame_block.h"
#include "sinew/render/gl_glyphs.h"
#include "sinew/render/gl_mesh.h"
#include "sinew/render/gl_overlay.h"
#include "sinew/render/gl_sky.h"

namespace sinew {
namespace {

constexpr int key_maps = 32, sky_maps = 64;

gl::Vec4f vec4(const Vec3f& v, float w) { return {v.x(), v.y(), v.z(), w}; }
gl::Vec4f vec4(Colour c) {
    return {static_cast<float>(c.r) / 255, static_cast<float>(c.g) / 255, static_cast<float>(c.b) / 255,
            static_cast<float>(c.a) / 255};
}

gl::FrameBlock frame_block(const Camera& camera, int width, int height, const DrawOptions& options,
                           const Bounds& scene, const Bounds& all) {
    const Eigen::Matrix4f view = view_matrix(camera);
    const Eigen::Matrix3f turn = view.topLeftCorner<3, 3>();
    const bool perspective = camera.projection == Projection::perspective;
    gl::FrameBlock frame{};
    frame.view = view;
    frame.projection = projection_matrix(camera, static_cast<double>(width) / height, all);
    frame.viewport = {static_cast<float>(width), static_cast<float>(height), perspective ? 1.f : 0.f, 0.f};
    frame.up = vec4(turn.col(2), 0);
    frame.key = vec4(options.lights.key.normalized(), options.lights.key_strength);
    frame.fill = vec4(options.lights.fill.normalized(), options.lights.fill_strength);
    frame.rim = vec4(options.lights.rim.normalized(), options.lights.rim_strength);
    frame.mesh_colour = vec4(options.mesh_colour);
    frame.mesh_colour.w() = options.mesh ? std::clamp(options.opacity, 0.f, 1.f) : 1;
    frame.wire_colour = vec4(options.wire_colour);
    if (!options.wire) frame.wire_colour.w() = 0;
    frame.style = {static_cast<float>(options.shading), options.wire_width,
                   scene.isEmpty() ? 0 : scene.min().z(), options.ground_shadow};
    frame.extent = {0, 0, 0, 1};
    if (!scene.isEmpty()) frame.extent = vec4(scene.center(), std::max(scene.diagonal().norm() / 2, 1e-30f));
    return frame;
}

}  // namespace

/// What the maps of the sky depend on beside the scene itself.
struct SkyKey {
    Vec3f key = Vec3f::Zero();
    bool mesh = false, glyphs = false;

    bool operator==(const SkyKey& other) const {
        return key == other.key && mesh == other.mesh && glyphs == other.glyphs;
    }
};

struct GlScene::State {
    gl::MeshDrawing mesh;
    gl::GlyphDrawing glyphs;
    gl::OverlayDrawing overlay;
    gl::SkyMaps sky;
    gl::Buffer frame;
    gl::MarkBatch irregular, creases, points, lines, planes;
    Bounds mesh_bounds, glyph_bounds, mark_bounds;
    bool sky_stale = true;
    SkyKey sky_key;

    void upload_frame(const gl::FrameBlock& block) const { gl::upload(frame, &block, sizeof block); }

    Bounds visible_bounds(const DrawOptions& options) const {
        Bounds box;
        if (options.mesh) box.extend(mesh_bounds);
        if (options.glyphs) box.extend(glyph_bounds);
        return box;
    }

    void update_sky(const gl::FrameBlock& block, const DrawOptions& options);
    void draw_solid(const DrawOptions& options, bool shadows) const;
    void draw_overlay(const gl::FrameBlock& block, const DrawOptions& options) const;
};

void GlScene::State::update_sky(const gl::FrameBlock& block, const DrawOptions& options) {
    const Vec3f key = block.view.topLeftCorner<3, 3>().transpose() * block.key.head<3>();
    const SkyKey wanted{key, options.mesh, options.glyphs && block.mesh_colour.w() == 1};
    if (!sky_stale && wanted == sky_key) return;
    gl::FrameBlock map_block = block;
    map_block.projection.setIdentity();
    int target = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
    int read = 0;
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, frame.name());
    sky.render(block.extent.head<3>(), block.extent.w() * 1.01f, gl::sky_directions(key, key_maps, sky_maps),
               key_maps, [&](const gl::Mat4f& view) {
                   map_block.view = view;
                   upload_frame(map_block);
                   if (wanted.mesh) mesh.draw_depth();
                   if (wanted.glyphs) glyphs.draw_depth();
               });
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<unsigned>(target));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<unsigned>(read));
    sky_key = wanted;
    sky_stale = false;
}

/// Depth alone first where it pays: only the nearest layer of a transparent mesh is blended over the glyphs,
/// and what is dear to light is lit once a pixel.
template <class Drawing>
void draw_with_depth_first(const Drawing& drawing, bool depth_first) {
    if (depth_first) {
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        drawing.draw_depth();
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    }
    drawing.draw();
}

void GlScene::State::draw_solid(const DrawOptions& options, bool shadows) const {
    if (options.glyphs) draw_with_depth_first(glyphs, shadows);
    if (options.mesh && options.opacity > 0) draw_with_depth_first(mesh, shadows || options.opacity < 1);
}

void GlScene::State::draw_overlay(const gl::FrameBlock& block, const DrawOptions& options) const {
    glDepthMask(GL_FALSE);
    if (block.viewport.w() > 0 && options.ground_shadow > 0) overlay.draw_ground();
    if (options.marks) overlay.draw_planes(planes);
    if (options.creases) overlay.draw_lines(creases);
    if (options.marks) overlay.draw_lines(lines);
    if (options.irregular) overlay.draw_points(irregular);
    if (options.marks) overlay.draw_points(points);
    glDepthMask(GL_TRUE);
}

Result<GlScene> GlScene::create() {
    if (epoxy_gl_version() < 33)
        return fail(ErrorKind::program, "the graphics driver offers less than OpenGL 3.3",
                    "update it, or install Mesa");
    auto state = std::make_unique<State>();
    auto mesh = gl::MeshDrawing::create();
    if (!mesh) return fail(mesh.error());
    auto glyphs = gl::GlyphDrawing::create();
    if (!glyphs) return fail(glyphs.error());
    auto overlay = gl::OverlayDrawing::create();
    if (!overlay) return fail(overlay.error());
    state->mesh = std::move(*mesh);
    state->glyphs = std::move(*glyphs);
    state->overlay = std::move(*overlay);
    state->sky = gl::SkyMaps::create();
    state->frame = gl::Buffer::make();
    state->irregular = state->overlay.make_points();
    state->points = state->overlay.make_points();
    state->creases = state->overlay.make_lines();
    state->lines = state->overlay.make_lines();
    state->planes = state->overlay.make_planes();
    return GlScene(std::move(state));
}

GlScene::GlScene(std::unique_ptr<State> state) : state_(std::move(state)) {}
GlScene::GlScene(GlScene&&) noexcept = default;
GlScene& GlScene::operator=(GlScene&&) noexcept = default;
GlScene::~GlScene() = default;

void GlScene::set_mesh(const MeshBuffers& mesh) {
    state_->mesh.set(mesh);
    gl::set_marks(state_->irregular, std::span(mesh.irregular));
    gl::set_marks(state_->creases, std::span(mesh.creases));
    state_->mesh_bounds = mesh.bounds;
    state_->sky_stale = true;
}

void GlScene::set_glyphs(const Glyphs& glyphs) {
    state_->glyphs.set(glyphs);
    state_->glyph_bounds = glyphs.bounds();
    state_->sky_stale = true;
}

void GlScene::set_lines(std::span<const LineMark> lines) { gl::set_marks(state_->lines, lines); }
void GlScene::set_points(std::span<const PointMark> points) { gl::set_marks(state_->points, points); }

void GlScene::set_planes(std::span<const PlaneMark> planes) {
    gl::set_marks(state_->planes, planes);
    state_->mark_bounds.setEmpty();
    for (const PlaneMark& plane : planes)
        for (const float side : {-1.f, 1.f}) {
            state_->mark_bounds.extend(plane.origin + side * (plane.u + plane.v));
            state_->mark_bounds.extend(plane.origin + side * (plane.u - plane.v));
        }
}

Bounds GlScene::bounds() const { return state_->mesh_bounds.merged(state_->glyph_bounds); }

void GlScene::draw(const Camera& camera, int width, int height, const DrawOptions& options) {
    State& state = *state_;
    const Bounds scene = state.visible_bounds(options);
    const bool shadows = options.shadows && !scene.isEmpty();
    Bounds all = scene;
    if (options.marks) all.extend(state.mark_bounds);
    if (shadows && options.ground_shadow > 0) {
        const float reach = 2.5f * scene.diagonal().norm() / 2;
        all.extend(Vec3f(scene.center() - Vec3f(reach, reach, 0)));
        all.extend(Vec3f(scene.center() + Vec3f(reach, reach, 0)));
    }
    gl::FrameBlock block = frame_block(camera, width, height, options, scene, all);
    if (shadows) state.update_sky(block, options);
    block.viewport.w() = shadows ? 1.f : 0.f;
    state.upload_frame(block);

    glBindBufferBase(GL_UNIFORM_BUFFER, 0, state.frame.name());
    state.sky.bind();
    glViewport(0, 0, width, height);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_TRUE);
    glDisable(GL_CULL_FACE);
    glEnable(GL_PROGRAM_POINT_SIZE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    state.draw_solid(options, shadows);
    state.draw_overlay(block, options);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(0);
    glBindVertexArray(0);
    glBindBuffer(GL_UNIFORM_BUFFER, 0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
}

}  // namespace sinew
