/// @file shapes.h
/// Meshes whose every number is known.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "sinew/mesh/quad_mesh.h"

namespace sinew::shapes {

/// Faces outward; its twelve edges are creases if wanted.
inline QuadMesh box(const Vec3f& centre, const Vec3f& half, bool creased = false) {
    QuadMesh mesh;
    for (unsigned i = 0; i < 8; ++i)
        mesh.positions.push_back(centre +
                                 half.cwiseProduct(Vec3f(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
    using Face = std::array<std::uint32_t, 4>;
    for (const Face& f :
         {Face{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
        mesh.add_face(f);
        for (int i = 0; creased && i < 4; ++i)
            if (f[i] < f[(i + 1) % 4]) mesh.features.creases.push_back({{f[i], f[(i + 1) % 4]}, 10});
    }
    return mesh;
}

/// A ball of n meridians and n / 2 - 1 parallels, with a pole at the top and one at the bottom.
inline QuadMesh sphere(const Vec3f& centre, float radius, std::uint32_t n) {
    constexpr float pi = std::numbers::pi_v<float>;
    QuadMesh mesh;
    const std::uint32_t rows = n / 2 - 1;
    for (std::uint32_t r = 1; r <= rows; ++r)
        for (std::uint32_t c = 0; c < n; ++c) {
            const float a = pi * float(r) / float(rows + 1) - pi / 2, b = 2 * pi * float(c) / float(n);
            mesh.positions.push_back(
                centre + radius * Vec3f(std::cos(a) * std::cos(b), std::cos(a) * std::sin(b), std::sin(a)));
        }
    mesh.positions.push_back(centre - radius * Vec3f::UnitZ());
    mesh.positions.push_back(centre + radius * Vec3f::UnitZ());
    const auto at = [n](std::uint32_t r, std::uint32_t c) { return r * n + c % n; };
    for (std::uint32_t c = 0; c < n; ++c) {
        mesh.add_face(std::array{rows * n, at(0, c + 1), at(0, c)});
        for (std::uint32_t r = 0; r + 1 < rows; ++r)
            mesh.add_face(std::array{at(r, c), at(r, c + 1), at(r + 1, c + 1), at(r + 1, c)});
        mesh.add_face(std::array{rows * n + 1, at(rows - 1, c), at(rows - 1, c + 1)});
    }
    return mesh;
}

/// A square of n by n unit quads in the plane y = 0, seen from the front.
inline QuadMesh grid(std::uint32_t n) {
    QuadMesh mesh;
    for (std::uint32_t z = 0; z <= n; ++z)
        for (std::uint32_t x = 0; x <= n; ++x) mesh.positions.emplace_back(float(x), 0, float(z));
    for (std::uint32_t z = 0; z < n; ++z)
        for (std::uint32_t x = 0; x < n; ++x) {
            const std::uint32_t a = z * (n + 1) + x;
            mesh.add_face(std::array{a, a + 1, a + n + 2, a + n + 1});
        }
    return mesh;
}

}  // namespace sinew::shapes
