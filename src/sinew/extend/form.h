/// @file form.h
/// What a node is where it is no plain ball: an outline or a body with axes of its own.
#pragma once

#include <cstdint>

#include "sinew/base/vec.h"
#include "sinew/skeleton/document.h"

namespace sinew {

/// The outline of a ring, or the body of a joint.
struct Form {
    enum class Kind : std::uint8_t {
        ring,   ///< an outline in the plane of x and y (or turned into the bisector of a bend)
        box,    ///< a joint whose surface is a box
        ball,   ///< a joint whose surface is an ellipsoid
        blend,  ///< a joint of round cones as usual; it has a form because of what happens on it
    };
    Kind kind = Kind::ring;
    Section section = Section::round;
    Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();  ///< unit, right-handed; z along the bone
    Vec3 half = Vec3::Ones();  ///< half extents along x, y, z (rings: z unused)
    bool fixed = false;        ///< ring: stands at right angles to z, whatever its bones do
    std::int32_t sides = 4;    ///< vertices that its paths have at least
    double sharpness = 0;  ///< of the crease on the ring; on a joint: of the creases where its tubes begin

    /// A vector in the space where a ball is the unit ball and a box the cube from -1 to 1.
    Vec3 local(const Vec3& v) const {
        return {v.dot(x) / half.x(), v.dot(y) / half.y(), v.dot(z) / half.z()};
    }
};

/// An ellipsoid is a round ball in a space of its own, where its cells and points are found as a ball's are:
/// unit directions from there, and there. Great circles stay great circles. Other forms (and none) have no
/// such space: their directions stay.
inline bool is_ellipsoid(const Form* form) {
    return form && form->kind == Form::Kind::ball &&
           !(form->half.x() == form->half.y() && form->half.y() == form->half.z());
}
Vec3 stretched(const Form& form, const Vec3& direction, const Vec3& by);  ///< unit; along the form's axes
inline Vec3 from_ball_space(const Form* form, const Vec3& direction) {
    return is_ellipsoid(form) ? stretched(*form, direction, form->half) : direction;
}
inline Vec3 to_ball_space(const Form* form, const Vec3& direction) {
    return is_ellipsoid(form) ? stretched(*form, direction, form->half.cwiseInverse()) : direction;
}

/// Distance from the centre to where a unit ray leaves the ellipsoid, or the box, of a form's axes and half
/// extents.
double exit_of_ellipsoid(const Form& form, const Vec3& ray);
double exit_of_box(const Form& form, const Vec3& ray);

}  // namespace sinew
