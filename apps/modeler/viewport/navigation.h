/// @file navigation.h
/// How the camera moves under the hand. Pure functions of renderer's Camera; pixels are logical ones.
#pragma once

#include <Qt>

#include "actions/action.h"
#include "document/screen.h"
#include "sinew/render/bounds.h"
#include "sinew/render/camera.h"

namespace sinew::modeler {

/// What tools need to know of the camera, in double precision.
Screen screen_of(const Camera& camera, const Vec2& size);

/// The camera that a new window starts with: a perspective, slightly from above, of a few units.
Camera home_camera();

/// What a button and the keys held with it drag: the tool's own, or the camera.
enum class Drag : std::uint8_t { none, tool, orbit, pan, zoom };
Drag drag_of(Qt::MouseButton button, Qt::KeyboardModifiers held);

/// The camera after a drag of so many pixels that was begun at a pixel; the same for Drag::none and tool.
Camera dragged(const Camera& camera, Drag drag, const Vec2& pixels, const Vec2& begun_at, const Vec2& size);

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
