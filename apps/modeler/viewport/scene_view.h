/// @file scene_view.h
/// The layers of the viewport on the graphics card. Everything here needs the viewport's context.
#pragma once

#include <memory>
#include <optional>

#include "document/model.h"
#include "document/view_settings.h"
#include "live/pipeline.h"
#include "sinew/render/gl_scene.h"
#include "tools/interaction.h"

namespace sinew::modeler {

/// How large glyphs are while the mesh is shown round them.
inline constexpr double glyph_scale_in_mesh = 0.42;

class SceneView {
  public:
    static Result<SceneView> create();

    void set_mesh(std::shared_ptr<const LiveMesh> mesh);

    /// Uploads what has changed and draws over what the bound framebuffer shows; its depth is cleared first.
    /// @param width, height  in pixels of the device
    void draw(const Model& model, Interaction& tools, const ViewSettings& view, const Camera& camera,
              int width, int height, double pixel_ratio);

  private:
    /// What the glyphs on the card were made from.
    struct GlyphKey {
        std::uint64_t revision = ~0ull;
        double scale = 0;
        Selection selection;
        Hit hovered;
        bool inside = false;
        bool operator==(const GlyphKey& other) const;
    };
    SceneView(GlScene&& surface, GlScene&& skeleton)
        : surface_(std::move(surface)), skeleton_(std::move(skeleton)) {}
    void update_glyphs(const Model& model, Interaction& tools, bool inside);
    void update_planes(const Model& model, const ViewSettings& view, bool dragging);

    GlScene surface_;   ///< mesh, planes, and the glyphs where they are seen through it
    GlScene skeleton_;  ///< glyphs over the mesh
    std::shared_ptr<const LiveMesh> mesh_;
    GlyphKey key_;
    std::uint64_t planes_revision_ = ~0ull;
    bool planes_grid_ = false;
    float ground_reach_ = 0;
};

}  // namespace sinew::modeler
