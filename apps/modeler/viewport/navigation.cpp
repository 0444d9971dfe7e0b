#include "viewport/navigation.h"

#include <cmath>
#include <numbers>

#include "document/images.h"

namespace sinew::modeler {
namespace {

const double degrees_a_pixel = 0.4;
const double zoom_a_notch = 0.88;
const double zoom_pixels = 40;  ///< of a drag, for a notch

}  // namespace

Screen screen_of(const Camera& camera, const Vec2& size) {
    Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
    const Mat3 turn = axes_of(camera).transpose();
    view.topLeftCorner<3, 3>() = turn;
    view.topRightCorner<3, 1>() = -(turn * eye_of(camera));
    Eigen::Matrix4d projection = Eigen::Matrix4d::Zero();
    const double up = 2 / visible_height(camera), right = up * size.y() / size.x();
    if (camera.projection == Projection::perspective) {
        const double near = camera.distance * 1e-3, far = camera.distance * 1e3;
        projection(0, 0) = right * camera.distance;
        projection(1, 1) = up * camera.distance;
        projection(2, 2) = -(far + near) / (far - near);
        projection(2, 3) = -2 * far * near / (far - near);
        projection(3, 2) = -1;
    } else {
        projection(0, 0) = right;
        projection(1, 1) = up;
        projection(2, 2) = -1 / (camera.distance * 1e3);  // rays start far behind the eye
        projection(3, 3) = 1;
    }
    return {projection * view, size};
}

Camera home_camera() { return {.distance = 14, .azimuth = 30, .elevation = 18}; }

Drag drag_of(Qt::MouseButton button, Qt::KeyboardModifiers held) {
    const bool left = button == Qt::LeftButton;
    if (left && !held.testFlag(Qt::AltModifier)) return Drag::tool;
    if (!left && button != Qt::MiddleButton && button != Qt::RightButton) return Drag::none;
    if (held.testFlag(Qt::ShiftModifier)) return Drag::pan;
    return held.testFlag(Qt::ControlModifier) ? Drag::zoom : Drag::orbit;
}

Camera dragged(const Camera& camera, Drag drag, const Vec2& pixels, const Vec2& begun_at, const Vec2& size) {
    switch (drag) {
        case Drag::orbit:
            return orbited(camera, pixels);
        case Drag::pan:
            return panned(camera, pixels, size);
        case Drag::zoom:
            return zoomed(camera, -pixels.y() / zoom_pixels, begun_at, size);
        default:
            return camera;
    }
}

Camera orbited(const Camera& camera, const Vec2& pixels) {
    return orbit(camera, -pixels.x() * degrees_a_pixel, pixels.y() * degrees_a_pixel);
}

Camera panned(const Camera& camera, const Vec2& pixels, const Vec2& size) {
    return pan(camera, -pixels.x() / size.y(), pixels.y() / size.y());
}

Camera zoomed(const Camera& camera, double notches, const Vec2& pixel, const Vec2& size) {
    const double factor = std::pow(zoom_a_notch, notches);
    const Vec2 from_middle = (pixel - size / 2) / size.y();
    const Camera shifted = pan(camera, from_middle.x(), -from_middle.y());
    return pan(zoom(shifted, factor), -from_middle.x(), from_middle.y());
}

Camera looking(Camera camera, StandardView view) {
    constexpr double azimuths[] = {0, 180, 90, -90, 0, 0};
    constexpr double elevations[] = {0, 0, 0, 0, 90, -90};
    camera.azimuth = azimuths[static_cast<int>(view)];
    camera.elevation = elevations[static_cast<int>(view)];
    camera.projection = Projection::orthographic;
    return camera;
}

Camera framed(const Camera& camera, const Bounds& box, const Vec2& size) {
    return fit(camera, box, size.x() / size.y(), 0.12);
}

Bounds bounds_of(const Document& document, std::span<const std::int32_t> nodes) {
    Bounds box;
    for (const Mat3& image : images_of(document.symmetry))
        for (std::int32_t i : nodes) {
            const Node& node = document.nodes[i];
            const double reach = node.size ? std::max(node.radius, node.size->norm() / 2) : node.radius;
            const Vec3 centre = image * node.position;
            box.extend(Vec3f((centre - Vec3::Constant(reach)).cast<float>()));
            box.extend(Vec3f((centre + Vec3::Constant(reach)).cast<float>()));
        }
    return box;
}

}  // namespace sinew::modeler
