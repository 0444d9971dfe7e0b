/// @file overlay.h
/// What is painted over the scene, in pixels: the gizmo, guides, outlines, names, the axes in the corner.
#pragma once

#include <QPointF>
#include <optional>
#include <vector>

#include "document/model.h"
#include "document/screen.h"
#include "document/view_settings.h"
#include "sinew/render/camera.h"
#include "tools/gizmo.h"
#include "tools/interaction.h"

class QPainter;
class QString;

namespace sinew::modeler {

struct Overlay {
    QPainter& painter;
    const Screen& screen;

    /// Rings round what is selected; circles as large as the tube will be at the active and the hovered node.
    void outlines(const Model& model, const Glyphing& glyphs, const Hit& hovered) const;
    void names(const Model& model) const;
    void gizmo(const Vec3& at, const std::optional<AxisLock>& hovered) const;
    void guides(const Guides& guides) const;
    void hint(const QString& text) const;     ///< at the bottom, large enough to read while dragging
    void message(const QString& text) const;  ///< in the middle, where there is nothing else to see
};

/// A ball of the axes in the corner: click to look from there.
struct AxisBall {
    Vec2 centre;
    double depth;  ///< larger is nearer to the eye
    int axis;
    bool positive;
};
/// Back to front.
std::vector<AxisBall> axis_balls(const Camera& camera, const Vec2& size);
std::optional<StandardView> axis_ball_at(const Camera& camera, const Vec2& size, const Vec2& pixel);
void paint_axis_balls(QPainter& painter, const Camera& camera, const Vec2& size,
                      const std::optional<StandardView>& hovered);

}  // namespace sinew::modeler
