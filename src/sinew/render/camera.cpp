#include "sinew/render/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace sinew {
namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180; }
double half_tangent(const Camera& camera) { return std::tan(radians(camera.field_of_view) / 2); }

std::array<Vec3f, 8> corners_of(const Bounds& bounds) {
    std::array<Vec3f, 8> corners;
    for (int i = 0; i < 8; ++i) corners[i] = bounds.corner(static_cast<Bounds::CornerType>(i));
    return corners;
}

/// How far the points reach to both sides of one axis of the picture. An eye at `offset` along the axis and
/// at distance D from the target sees a point at x, d behind the target, iff |x - offset| <= t (D + d). So
/// high = max(x - t d) <= offset + t D, and low = max(-x - t d) <= t D - offset.
struct Reach {
    double low = -std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double x, double t, double depth) {
        high = std::max(high, x - t * depth);
        low = std::max(low, -x - t * depth);
    }
    double offset() const { return (high - low) / 2; }
    double half_width() const { return (high + low) / 2; }
};

}  // namespace

Camera camera_of(View view) {
    switch (view) {
        case View::front:
            return {.projection = Projection::orthographic};
        case View::side:
            return {.azimuth = 90, .projection = Projection::orthographic};
        case View::top:
            return {.elevation = 90, .projection = Projection::orthographic};
        case View::iso:
            break;
    }
    return {.azimuth = 35, .elevation = 20};
}

Mat3 axes_of(const Camera& camera) {
    const double a = radians(camera.azimuth), e = radians(camera.elevation);
    Mat3 axes;
    axes.col(0) = Vec3(std::cos(a), std::sin(a), 0);
    axes.col(2) = Vec3(std::sin(a) * std::cos(e), -std::cos(a) * std::cos(e), std::sin(e));
    axes.col(1) = axes.col(2).cross(axes.col(0));
    return axes;
}

Vec3 eye_of(const Camera& camera) { return camera.target + camera.distance * axes_of(camera).col(2); }

double visible_height(const Camera& camera) { return 2 * camera.distance * half_tangent(camera); }

Camera fit(Camera camera, std::span<const Vec3f> points, double aspect, double margin) {
    if (points.empty()) return camera;
    const Mat3 axes = axes_of(camera);
    const bool perspective = camera.projection == Projection::perspective;
    const double free = 1 - 2 * margin;
    const double ty = half_tangent(camera) * free, tx = ty * aspect;
    Reach x, y;
    double nearest = 0;
    for (const Vec3f& point : points) {
        const Vec3 local = axes.transpose() * (point.cast<double>() - camera.target);
        const double depth = perspective ? -local.z() : 0;
        nearest = std::max(nearest, local.z());
        x.add(local.x(), tx, depth);
        y.add(local.y(), ty, depth);
    }
    camera.target += axes.col(0) * x.offset() + axes.col(1) * y.offset();
    double distance = std::max(x.half_width() / tx, y.half_width() / ty);
    if (perspective) distance = std::max(distance, nearest * 1.01);
    if (distance > 0) camera.distance = distance;
    return camera;
}

Camera fit(const Camera& camera, const Bounds& bounds, double aspect, double margin) {
    if (bounds.isEmpty()) return camera;
    return fit(camera, corners_of(bounds), aspect, margin);
}

Camera orbit(Camera camera, double azimuth, double elevation) {
    camera.azimuth = std::remainder(camera.azimuth + azimuth, 360);
    camera.elevation = std::clamp(camera.elevation + elevation, -90.0, 90.0);
    return camera;
}

Camera pan(Camera camera, double right, double up) {
    const Mat3 axes = axes_of(camera);
    camera.target += visible_height(camera) * (right * axes.col(0) + up * axes.col(1));
    return camera;
}

Camera zoom(Camera camera, double factor) {
    camera.distance *= factor;
    return camera;
}

Eigen::Matrix4f view_matrix(const Camera& camera) {
    const Mat3 turn = axes_of(camera).transpose();
    Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
    view.topLeftCorner<3, 3>() = turn;
    view.topRightCorner<3, 1>() = -(turn * eye_of(camera));
    return view.cast<float>();
}

Eigen::Matrix4f projection_matrix(const Camera& camera, double aspect, const Bounds& bounds) {
    const bool perspective = camera.projection == Projection::perspective;
    double near = camera.distance * 0.5, far = camera.distance * 1.5;
    if (!bounds.isEmpty()) {
        const Vec3 back = axes_of(camera).col(2), eye = eye_of(camera);
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const Vec3f& corner : corners_of(bounds)) {
            const double depth = back.dot(eye - corner.cast<double>());
            low = std::min(low, depth);
            high = std::max(high, depth);
        }
        const double slack = 0.01 * (high - low) + 1e-4 * camera.distance;
        far = high + slack;
        near = low - slack;
    }
    if (perspective) {
        far = std::max(far, 1e-3 * camera.distance);
        near = std::clamp(near, 1e-3 * far, 0.999 * far);
    }
    const double top = perspective ? half_tangent(camera) : visible_height(camera) / 2;
    Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
    m(0, 0) = 1 / (top * aspect);
    m(1, 1) = 1 / top;
    if (perspective) {
        m(2, 2) = -(far + near) / (far - near);
        m(2, 3) = -2 * far * near / (far - near);
        m(3, 2) = -1;
    } else {
        m(2, 2) = -2 / (far - near);
        m(2, 3) = -(far + near) / (far - near);
        m(3, 3) = 1;
    }
    return m.cast<float>();
}

}  // namespace sinew
