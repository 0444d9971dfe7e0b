#include "viewport/scene_view.h"

#include <epoxy/gl.h>

#include "viewport/scene_glyphs.h"

namespace sinew::modeler {
namespace {

const double in_front = 0.02;  ///< share of the depth range that is kept for what is drawn over the mesh

}  // namespace

bool SceneView::GlyphKey::operator==(const GlyphKey& other) const {
    return revision == other.revision && scale == other.scale && selection == other.selection &&
           hovered.same_thing(other.hovered) && inside == other.inside;
}

Result<SceneView> SceneView::create() {
    auto surface = GlScene::create();
    if (!surface) return fail(surface.error());
    auto skeleton = GlScene::create();
    if (!skeleton) return fail(skeleton.error());
    return SceneView(std::move(*surface), std::move(*skeleton));
}

void SceneView::set_mesh(std::shared_ptr<const LiveMesh> mesh) {
    if (mesh_ && mesh && mesh_->buffers == mesh->buffers) return;
    mesh_ = std::move(mesh);
    surface_.set_mesh(mesh_ && mesh_->buffers ? *mesh_->buffers : MeshBuffers{});
}

void SceneView::update_glyphs(const Model& model, Interaction& tools, bool inside) {
    GlyphKey key{model.revision(), tools.glyph_scale, model.selection(), tools.hovered(), inside};
    if (key == key_) return;
    const Glyphs glyphs = scene_glyphs(model.document(), tools.glyphs(), model.selection(), tools.hovered());
    (inside ? surface_ : skeleton_).set_glyphs(glyphs);
    (inside ? skeleton_ : surface_).set_glyphs({});
    key_ = std::move(key);
}

void SceneView::update_planes(const Model& model, const ViewSettings& view, bool dragging) {
    if (planes_revision_ == model.revision() && planes_grid_ == view.grid) return;
    // While one drags outwards the ground and the plane stay as large as they were.
    const Document& document = dragging ? model.before_drag() : model.document();
    if (!dragging || ground_reach_ == 0) ground_reach_ = reach_of(document);
    std::vector<PlaneMark> planes;
    if (view.grid) planes.push_back(ground_plane(ground_reach_));
    if (auto mirror = mirror_plane(document)) planes.push_back(*mirror);
    surface_.set_planes(planes);
    skeleton_.set_planes(planes);
    planes_revision_ = model.revision();
    planes_grid_ = view.grid;
}

void SceneView::draw(const Model& model, Interaction& tools, const ViewSettings& view, const Camera& camera,
                     int width, int height, double pixel_ratio) {
    const bool mesh = view.live && mesh_ && mesh_->buffers;
    const bool inside = mesh && view.opacity < 1;
    tools.glyph_scale = mesh ? glyph_scale_in_mesh : 1;
    update_glyphs(model, tools, inside);
    update_planes(model, view, model.previewing() && !tools.locked);

    glDepthMask(GL_TRUE);
    glClear(GL_DEPTH_BUFFER_BIT);
    DrawOptions options;
    options.shading = view.shading;
    options.opacity = static_cast<float>(view.opacity);
    options.wire = view.wire;
    options.wire_width = static_cast<float>(1.1 * pixel_ratio);
    options.wire_colour = {30, 32, 40, 150};
    options.irregular = view.irregular;
    options.creases = view.creases;
    options.glyphs = inside && view.bones;
    if (mesh) surface_.draw(camera, width, height, options);
    if (inside || !view.bones) return;
    options.mesh = false;
    options.irregular = options.creases = false;
    options.glyphs = true;
    options.marks = !mesh;
    if (mesh) glDepthRange(0, in_front);
    skeleton_.draw(camera, width, height, options);
    glDepthRange(0, 1);
}

}  // namespace sinew::modeler
