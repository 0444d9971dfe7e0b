#include "sinew/sqm/bridge/lone_sphere.h"

#include <algorithm>
#include <utility>

namespace sinew::sqm {
namespace {

using Point = std::array<int, 3>;
using Face = std::array<std::uint32_t, 4>;

std::array<Point, 26> make_points() {
    std::array<Point, 26> points{};
    std::size_t at = 0;
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                if (x || y || z) points[at++] = {x, y, z};
    return points;
}

std::uint32_t index_of(const Point& point) {
    const auto& points = lone_sphere_points();
    return static_cast<std::uint32_t>(std::find(points.begin(), points.end(), point) - points.begin());
}

/// The quad of one side of the cube whose corner of the lowest coordinates is (u, v) in that side.
Face face_at(int axis, int side, int u, int v) {
    const auto corner = [&](int du, int dv) {
        Point point{};
        point[axis] = side;
        point[(axis + 1) % 3] = u + du;
        point[(axis + 2) % 3] = v + dv;
        return index_of(point);
    };
    Face face{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
    if (side < 0) std::swap(face[1], face[3]);
    return face;
}

std::array<Face, 24> make_faces() {
    std::array<Face, 24> faces{};
    std::size_t at = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {-1, 1})
            for (const int u : {-1, 0})
                for (const int v : {-1, 0}) faces[at++] = face_at(axis, side, u, v);
    return faces;
}

}  // namespace

const std::array<Point, 26>& lone_sphere_points() {
    static const auto points = make_points();
    return points;
}

const std::array<Face, 24>& lone_sphere_faces() {
    static const auto faces = make_faces();
    return faces;
}

}  // namespace sinew::sqm
