#include "document/snap.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "document/images.h"

namespace sinew::modeler {
namespace {

const double node_reach = 14;     ///< pixels
const double symmetry_reach = 9;  ///< pixels
const double smallest_cell = 14;  ///< pixels

}  // namespace

double round_above(double length) {
    const double power = std::pow(10, std::floor(std::log10(length)));
    for (double factor : {1.0, 2.0, 5.0})
        if (factor * power >= length) return factor * power;
    return 10 * power;
}

double grid_step(const Screen& screen, const Vec3& at) {
    return round_above(smallest_cell * screen.pixel_length(at));
}

std::optional<Vec3> node_near(const Document& document, std::span<const std::int32_t> moving,
                              const Screen& screen, const Vec3& position) {
    const std::optional<Vec2> pixel = screen.project(position);
    if (!pixel) return std::nullopt;
    double reach = node_reach;
    std::optional<Vec3> found;
    for (std::int32_t i = 0; i < std::ssize(document.nodes); ++i) {
        if (std::binary_search(moving.begin(), moving.end(), i)) continue;
        const std::optional<Vec2> other = screen.project(document.nodes[i].position);
        if (!other || (*other - *pixel).norm() >= reach) continue;
        reach = (*other - *pixel).norm();
        found = document.nodes[i].position;
    }
    return found;
}

Snapped onto_near_symmetry(const Symmetry& symmetry, const Screen& screen, const Vec3& position) {
    if (symmetry.kind == Symmetry::Kind::none) return {position, false};
    const Vec3 there = onto_symmetry(symmetry, position);
    if ((there - position).norm() > symmetry_reach * screen.pixel_length(position)) return {position, false};
    return {there, true};
}

Vec3 onto_grid(const Vec3& position, double step) {
    return (position / step).array().round().matrix() * step;
}

Vec3 onto_angle(const Vec3& position, const Vec3& pivot, const Vec3& normal, double degrees) {
    // The world axis that lies flattest in the plane is where angles are counted from.
    int axis = 0;
    normal.cwiseAbs().minCoeff(&axis);
    const Vec3 unit = Vec3::Unit(axis);
    const Vec3 x = (unit - unit.dot(normal) * normal).normalized(), y = normal.cross(x);
    const Vec3 way = position - pivot;
    const double step = degrees * std::numbers::pi / 180;
    const double angle = std::round(std::atan2(way.dot(y), way.dot(x)) / step) * step;
    return pivot + std::hypot(way.dot(x), way.dot(y)) * (std::cos(angle) * x + std::sin(angle) * y);
}

}  // namespace sinew::modeler
