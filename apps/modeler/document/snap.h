/// @file snap.h
/// Where a moving node comes to rest: on other nodes, the mirror's plane, the grid, or a round angle.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "document/screen.h"
#include "sinew/skeleton/document.h"

namespace sinew::modeler {

/// What Ctrl snaps to where neither another node nor the mirror's plane is near.
enum class SnapTo : std::uint8_t { grid, angle };

struct Snapped {
    Vec3 position = Vec3::Zero();
    bool caught = false;  ///< something caught it: show it
};

/// 1, 2 or 5 times a power of ten, at least `length`.
double round_above(double length);

/// Distance of the lines of the finest grid that can still be told apart at a point: 1, 2 or 5 times a power
/// of ten.
double grid_step(const Screen& screen, const Vec3& at);

/// The nearest node on the screen, within reach of the pointer; the moving nodes (ascending) are left out.
std::optional<Vec3> node_near(const Document& document, std::span<const std::int32_t> moving,
                              const Screen& screen, const Vec3& position);

/// Onto the mirror's plane or the axis of a radial symmetry, where they are within reach on the screen.
Snapped onto_near_symmetry(const Symmetry& symmetry, const Screen& screen, const Vec3& position);

Vec3 onto_grid(const Vec3& position, double step);

/// Turned about `pivot` in the plane across `normal` to the nearest 15 degrees from the world's axes; as far
/// away as before.
Vec3 onto_angle(const Vec3& position, const Vec3& pivot, const Vec3& normal, double degrees = 15);

}  // namespace sinew::modeler
