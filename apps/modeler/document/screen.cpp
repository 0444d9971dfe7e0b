#include "document/screen.h"

#include <Eigen/LU>
#include <cmath>

namespace sinew::modeler {

Screen::Screen(const Eigen::Matrix4d& world_to_clip, const Vec2& size)
    : world_to_clip_(world_to_clip), clip_to_world_(world_to_clip.inverse()), size_(size) {}

Vec3 Screen::unproject(const Vec2& pixel, double depth) const {
    const Eigen::Vector4d clip(2 * pixel.x() / size_.x() - 1, 1 - 2 * pixel.y() / size_.y(), depth, 1);
    return (clip_to_world_ * clip).hnormalized();
}

Ray Screen::ray(const Vec2& pixel) const {
    const Vec3 near = unproject(pixel, -1), inside = unproject(pixel, 0);
    return {near, (inside - near).normalized()};
}

std::optional<Vec2> Screen::project(const Vec3& point) const {
    const Eigen::Vector4d clip = world_to_clip_ * point.homogeneous();
    if (clip.w() <= 0) return std::nullopt;
    return Vec2((clip.x() / clip.w() + 1) * size_.x() / 2, (1 - clip.y() / clip.w()) * size_.y() / 2);
}

Vec3 Screen::pixel_step(const Vec3& point, const Vec2& step) const {
    const Eigen::Vector4d clip = world_to_clip_ * point.homogeneous();
    const Vec3 at = clip.hnormalized();
    const Eigen::Vector4d moved(at.x() + 2 * step.x() / size_.x(), at.y() - 2 * step.y() / size_.y(), at.z(),
                                1);
    return (clip_to_world_ * moved).hnormalized() - point;
}

double Screen::pixel_length(const Vec3& point) const { return pixel_step(point, {1, 0}).norm(); }

Vec3 Screen::right(const Vec3& point) const { return pixel_step(point, {1, 0}).normalized(); }

Vec3 Screen::up(const Vec3& point) const { return pixel_step(point, {0, -1}).normalized(); }

Vec3 Screen::forward(const Vec3& point) const {
    const std::optional<Vec2> pixel = project(point);
    return ray(pixel ? *pixel : Vec2(size_ / 2)).direction;
}

Screen Screen::in_image(const Mat3& image) const {
    Eigen::Matrix4d placed = Eigen::Matrix4d::Identity();
    placed.topLeftCorner<3, 3>() = image;
    return {world_to_clip_ * placed, size_};
}

std::optional<Vec3> meet_plane(const Ray& ray, const Vec3& point, const Vec3& normal) {
    const double slope = ray.direction.dot(normal);
    if (std::abs(slope) < 1e-6) return std::nullopt;
    const double distance = (point - ray.origin).dot(normal) / slope;
    if (distance < 0) return std::nullopt;
    return ray.at(distance);
}

std::optional<Vec3> nearest_on_line(const Ray& ray, const Vec3& point, const Vec3& direction) {
    const Vec3 axis = direction.normalized();
    const Vec3 across = axis.cross(ray.direction);
    if (across.squaredNorm() < 1e-4) return std::nullopt;
    // The plane through the ray that holds the shortest way to the line.
    const Vec3 normal = ray.direction.cross(across);
    return point + (ray.origin - point).dot(normal) / axis.dot(normal) * axis;
}

}  // namespace sinew::modeler
