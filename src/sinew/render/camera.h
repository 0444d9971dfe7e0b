/// @file camera.h
/// A camera that orbits a target. World: z is up, models face -y, so that "front" looks along +y and "side"
/// along -x.
///
/// Plain value and pure functions: a viewport keeps one and replaces it on every event, a picture is taken
/// with one.
#pragma once

#include <cstdint>
#include <span>

#include "sinew/base/vec.h"
#include "sinew/render/bounds.h"

namespace sinew {

enum class View : std::uint8_t { front, side, top, iso };
enum class Projection : std::uint8_t { perspective, orthographic };

struct Camera {
    Vec3 target = Vec3::Zero();  ///< what it turns about and looks at
    double distance = 10;        ///< from the eye to the target, > 0
    double azimuth = 0;          ///< degrees about z, counter-clockwise seen from above; 0 stands at -y
    double elevation = 0;        ///< degrees above the horizon, -90 to 90
    double field_of_view =
        25;  ///< vertical, degrees; an orthographic camera shows the same height at the target
    Projection projection = Projection::perspective;
};

/// The usual views: front, side and top are orthographic, iso is a perspective from the front, the right and
/// above.
Camera camera_of(View view);

/// The camera moved (never turned) so that all points are in the picture, as large as they can be.
/// @param aspect  width over height of the picture
/// @param margin  share of the picture left free on each side, in [0, 0.5)
/// Without points the camera stays as it is.
Camera fit(Camera camera, std::span<const Vec3f> points, double aspect, double margin = 0.06);
Camera fit(const Camera& camera, const Bounds& bounds, double aspect, double margin = 0.06);

Camera orbit(Camera camera, double azimuth,
             double elevation);                      ///< turned by degrees; stops at the zenith and nadir
Camera pan(Camera camera, double right, double up);  ///< moved by shares of the visible height
Camera zoom(Camera camera, double factor);           ///< distance times factor

/// Columns: right, up, and back (towards the eye), in world coordinates.
Mat3 axes_of(const Camera& camera);
Vec3 eye_of(const Camera& camera);
/// Height of what is visible at the target.
double visible_height(const Camera& camera);

/// World to eye space (the eye looks along -z), as OpenGL wants it.
Eigen::Matrix4f view_matrix(const Camera& camera);
/// Eye space to clip space. The near and far planes enclose `bounds` and waste no depth on what is outside
/// them.
Eigen::Matrix4f projection_matrix(const Camera& camera, double aspect, const Bounds& bounds);

}  // namespace sinew
