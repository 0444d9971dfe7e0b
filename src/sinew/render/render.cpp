#include "sinew/render/render.h"

#include "sinew/render/egl_context.h"
#include "sinew/render/offscreen.h"

namespace sinew {
namespace {

/// Points whose hull holds all that is drawn solid: the camera is fitted to them rather than to a box, which
/// would leave gaps.
std::vector<Vec3f> outline_points(const Scene& scene, const DrawOptions& draw) {
    std::vector<Vec3f> points;
    const auto add_ball = [&](const Vec3f& centre, const Vec3f& half) {
        for (int i = 0; i < 8; ++i)
            points.emplace_back(centre + Vec3f(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(),
                                               i & 4 ? half.z() : -half.z()));
    };
    if (draw.mesh)
        for (const MeshVertex& v : scene.mesh.vertices)
            points.emplace_back(v.position[0], v.position[1], v.position[2]);
    if (!draw.glyphs) return points;
    for (const auto& list : scene.glyphs.shapes)
        for (const ShapeGlyph& g : list) add_ball(g.origin, g.x.cwiseAbs() + g.y.cwiseAbs() + g.z.cwiseAbs());
    for (const BoneGlyph& b : scene.glyphs.bones) {
        add_ball(b.from, Vec3f::Constant(b.from_radius));
        add_ball(b.to, Vec3f::Constant(b.to_radius));
    }
    return points;
}

}  // namespace

/// The context goes last: what was made in it goes while it is current.
struct Renderer::State {
    EglContext context;
    GlScene scene;

    ~State() { context.make_current(); }
};

Camera camera_for(const Scene& scene, const RenderOptions& options) {
    if (options.camera) return *options.camera;
    const double aspect = static_cast<double>(options.width) / std::max(1, options.height);
    return fit(camera_of(options.view), outline_points(scene, options.draw), aspect, options.margin);
}

Result<Renderer> Renderer::create() {
    auto context = EglContext::create();
    if (!context) return fail(context.error());
    auto scene = GlScene::create();
    if (!scene) return fail(scene.error());
    // NOLINTNEXTLINE(modernize-make-unique): an aggregate that cannot be moved
    return Renderer(std::unique_ptr<State>(new State{std::move(*context), std::move(*scene)}));
}

Result<Picture> Renderer::render(const Scene& scene, const RenderOptions& options) {
    state_->context.make_current();
    auto target = Offscreen::create(options.width, options.height);
    if (!target) return fail(target.error());
    GlScene& drawing = state_->scene;
    drawing.set_mesh(scene.mesh);
    drawing.set_glyphs(scene.glyphs);
    drawing.set_lines(scene.lines);
    drawing.set_points(scene.points);
    drawing.set_planes(scene.planes);
    target->begin(options.background);
    drawing.draw(camera_for(scene, options), options.width, options.height, options.draw);
    return target->read();
}

Renderer::Renderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Result<Picture> render(const Scene& scene, const RenderOptions& options) {
    auto renderer = Renderer::create();
    if (!renderer) return fail(renderer.error());
    return renderer->render(scene, options);
}

}  // namespace sinew
