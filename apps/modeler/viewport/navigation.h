/// @file navigation.h
/// How the camera moves under the hand. Pure functions of renderer's Camera; pixels are logical ones.
#pragma once

#include "actions/action.h"
#include "document/screen.h"
#include "sinew/render/bounds.h"
#include "sinew/render/camera.h"

namespace sinew::modeler {

/// What tools need to know of the camera, in double precision.
Screen screen_of(const Camera& camera, const Vec2& size);

/// The camera that a new window starts with: a perspective, slightly from above, of a few units.
Camera home_camera();

/// Turned by a drag of so many pixels.
Camera orbited(const Camera& camera, const Vec2& pixels);
/// Moved along by a drag of so many pixels: what is at the target's depth stays under the pointer.
Camera panned(const Camera& camera, const Vec2& pixels, const Vec2& size);
/// Nearer (notches > 0), towards what is under the pixel.
Camera zoomed(const Camera& camera, double notches, const Vec2& pixel, const Vec2& size);

/// Along an axis, without perspective; target and distance stay.
Camera looking(Camera camera, StandardView view);

/// Everything in the box in the picture; a box that is empty leaves the camera as it is.
Camera framed(const Camera& camera, const Bounds& box, const Vec2& size);

/// What the nodes given span, with their radii and images.
Bounds bounds_of(const Document& document, std::span<const std::int32_t> nodes);

}  // namespace sinew::modeler
