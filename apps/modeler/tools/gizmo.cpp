#include "tools/gizmo.h"

#include <algorithm>

namespace sinew::modeler {
namespace {

const double reach = 7;           ///< pixels
const double fades_below = 0.25;  ///< of an arm's full length on the screen

double distance_to_segment(const Vec2& point, const Vec2& a, const Vec2& b) {
    const Vec2 way = b - a;
    const double length2 = way.squaredNorm();
    const double along = length2 > 0 ? std::clamp((point - a).dot(way) / length2, 0.0, 1.0) : 0.0;
    return (a + along * way - point).norm();
}

/// How an axis of a length of one pixel looks on the screen.
Vec2 axis_on_screen(const Screen& screen, const Vec3& at, const Vec2& origin, int axis) {
    const std::optional<Vec2> tip = screen.project(at + screen.pixel_length(at) * Vec3::Unit(axis));
    return tip ? Vec2(*tip - origin) : Vec2(Vec2::Zero());
}

}  // namespace

std::vector<GizmoHandle> gizmo_handles(const Screen& screen, const Vec3& at) {
    std::vector<GizmoHandle> handles;
    const std::optional<Vec2> origin = screen.project(at);
    if (!origin) return handles;
    std::array<Vec2, 3> axes;
    for (int axis = 0; axis < 3; ++axis) {
        axes[axis] = axis_on_screen(screen, at, *origin, axis);
        const double shown = std::clamp(axes[axis].norm() / fades_below - 0.5, 0.0, 1.0);
        handles.push_back(
            {{axis, false}, *origin + gizmo_start * axes[axis], *origin + gizmo_arm * axes[axis], shown});
    }
    for (int axis = 0; axis < 3; ++axis) {
        const Vec2 &u = axes[(axis + 1) % 3], &v = axes[(axis + 2) % 3];
        const double area = std::abs(u.x() * v.y() - u.y() * v.x());
        const Vec2 middle = *origin + gizmo_square * (u + v);
        handles.push_back({{axis, true}, middle, middle, std::clamp(area / fades_below - 0.5, 0.0, 1.0)});
    }
    return handles;
}

std::optional<AxisLock> gizmo_at(const Screen& screen, const Vec3& at, const Vec2& pixel) {
    std::optional<AxisLock> found;
    double nearest = reach;
    for (const GizmoHandle& handle : gizmo_handles(screen, at)) {
        const double distance = distance_to_segment(pixel, handle.from, handle.to);
        if (handle.shown < 0.3 || distance >= nearest) continue;
        nearest = distance;
        found = handle.lock;
    }
    return found;
}

}  // namespace sinew::modeler
