/// @file screen.h
/// Between the world and the screen: what tools and picking need to know of a camera, and nothing more.
#pragma once

#include <optional>

#include "sinew/base/vec.h"

namespace sinew::modeler {

struct Ray {
    Vec3 origin = Vec3::Zero();
    Vec3 direction = Vec3::UnitZ();  ///< of length one

    Vec3 at(double distance) const { return origin + distance * direction; }
};

/// A camera as it is at one moment. Pixels are logical ones, with the origin at the top left.
class Screen {
  public:
    Screen() = default;
    Screen(const Eigen::Matrix4d& world_to_clip, const Vec2& size);

    /// The ray that leaves the camera through a pixel; it starts at the near plane.
    Ray ray(const Vec2& pixel) const;
    /// Where a point is on the screen; nothing for a point behind the camera.
    std::optional<Vec2> project(const Vec3& point) const;
    /// How long one pixel is at a point, in the world.
    double pixel_length(const Vec3& point) const;
    /// The directions of the screen at a point: into it, to the right, up.
    Vec3 forward(const Vec3& point) const;
    Vec3 right(const Vec3& point) const;
    Vec3 up(const Vec3& point) const;

    /// The same camera for someone who stands in an image of the world (see images.h): `image` maps drawn to
    /// shown.
    Screen in_image(const Mat3& image) const;

    const Vec2& size() const { return size_; }
    const Eigen::Matrix4d& world_to_clip() const { return world_to_clip_; }

  private:
    Vec3 unproject(const Vec2& pixel, double depth) const;
    Vec3 pixel_step(const Vec3& point, const Vec2& step) const;

    Eigen::Matrix4d world_to_clip_ = Eigen::Matrix4d::Identity();
    Eigen::Matrix4d clip_to_world_ = Eigen::Matrix4d::Identity();
    Vec2 size_{1, 1};
};

/// Where a ray meets a plane; nothing where it runs along it or away from it.
std::optional<Vec3> meet_plane(const Ray& ray, const Vec3& point, const Vec3& normal);

/// The point of a line that is nearest to a ray; nothing where they are parallel.
std::optional<Vec3> nearest_on_line(const Ray& ray, const Vec3& point, const Vec3& direction);

}  // namespace sinew::modeler
