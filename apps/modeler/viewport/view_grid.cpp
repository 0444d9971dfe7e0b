#include "viewport/view_grid.h"

#include <QPainter>
#include <cmath>

#include "document/snap.h"
#include "look/theme.h"

namespace sinew::modeler {
namespace {

/// All lines across one axis of the world that the screen shows.
void paint_lines(QPainter& painter, const Screen& screen, const Vec3& corner, const Vec3& opposite, int axis,
                 int along, double step) {
    const double low = std::min(corner[axis], opposite[axis]), high = std::max(corner[axis], opposite[axis]);
    for (double k = std::ceil(low / step); k <= high / step; ++k) {
        Vec3 from = corner, to = opposite;
        from[axis] = to[axis] = k * step;
        const auto a = screen.project(from), b = screen.project(to);
        if (!a || !b) continue;
        const bool middle = k == 0, major = std::fmod(std::abs(k), 5) == 0;
        QColor colour = middle ? theme::axis[along] : theme::grid;
        colour.setAlpha(middle ? 120 : major ? 44 : 18);
        painter.setPen(QPen(colour, 1));
        painter.drawLine(QPointF(a->x(), a->y()), QPointF(b->x(), b->y()));
    }
}

}  // namespace

int axis_seen_along(const Camera& camera) {
    int axis = 0;
    return axes_of(camera).col(2).cwiseAbs().maxCoeff(&axis) < 1 - 1e-6 ? -1 : axis;
}

void paint_view_grid(QPainter& painter, const Camera& camera, const Screen& screen) {
    const int axis = axis_seen_along(camera);
    if (axis < 0 || camera.projection != Projection::orthographic) return;
    const Vec3 unit = Vec3::Unit(axis);
    const auto corner = meet_plane(screen.ray({0, 0}), Vec3::Zero(), unit);
    const auto opposite = meet_plane(screen.ray(screen.size()), Vec3::Zero(), unit);
    if (!corner || !opposite) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    const double step = grid_step(screen, Vec3::Zero());
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    paint_lines(painter, screen, *corner, *opposite, u, v, step);
    paint_lines(painter, screen, *corner, *opposite, v, u, step);
    painter.restore();
}

}  // namespace sinew::modeler
