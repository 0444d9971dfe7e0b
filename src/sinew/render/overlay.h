/// @file overlay.h
/// Marks drawn with a size in pixels: points and lines over the scene.
#pragma once

#include "sinew/base/vec.h"
#include "sinew/render/colour.h"

namespace sinew {

struct PointMark {
    Vec3f position = Vec3f::Zero();
    float size = 7;  ///< diameter, pixels
    Colour colour;
};
static_assert(sizeof(PointMark) == 20);

struct LineMark {
    Vec3f from = Vec3f::Zero();
    Vec3f to = Vec3f::Zero();
    float width = 2;  ///< pixels
    Colour colour;
};
static_assert(sizeof(LineMark) == 32);

/// A plane seen from both sides: the ground with its grid, or the plane of a mirror.
struct PlaneMark {
    Vec3f origin = Vec3f::Zero();
    Vec3f u = Vec3f::UnitX();  ///< half its extent along one side
    Vec3f v = Vec3f::UnitY();  ///< half its extent along the other
    float cell = 0;            ///< spacing of grid lines; 0: none, only the tint and a border
    Colour tint{0, 0, 0, 0};   ///< of the plane itself
    Colour line{90, 94, 100, 160};
    bool fade = false;  ///< lines fade out towards the rim, and none is drawn there
};

}  // namespace sinew
