/// @file feature_shapes.h
/// Control meshes as the engine hands them over, with circles, planes, creases and corners.
#pragma once

#include <gtest/gtest.h>

#include "mesh/shapes.h"
#include "sinew/base/vec.h"
#include "sinew/mesh/limit.h"

namespace sinew::shapes {

/// The edges of a ring of n vertices from `first` on.
inline std::vector<MeshEdge> ring_edges(std::size_t first, std::size_t n) {
    std::vector<MeshEdge> edges;
    for (std::size_t j = 0; j < n; ++j) edges.push_back({index_of(first + j), index_of(first + (j + 1) % n)});
    return edges;
}

/// Faces round a vertex.
inline std::vector<std::uint32_t> faces_at(const QuadMesh& mesh, std::uint32_t vertex) {
    std::vector<std::uint32_t> faces;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (const std::uint32_t v : mesh.face(f))
            if (v == vertex) faces.push_back(index_of(f));
    return faces;
}

/// Makes the last or the first ring of a tube (see `tube`) the rim of a flat end.
inline void make_rim(QuadMesh& mesh, std::size_t m, std::size_t n, bool top, double radius = 1) {
    const std::size_t first = top ? (m - 1) * n : 0;
    const std::uint32_t pole = index_of(m * n + (top ? 1 : 0));
    const Vec3f centre(0, 0, mesh.positions[first].z());
    mesh.features.circles.push_back({centre, Vec3f::UnitZ(), float(radius), ring_edges(first, n)});
    for (const MeshEdge& edge : ring_edges(first, n)) mesh.features.creases.push_back({edge, 10});
    mesh.features.planes.push_back({centre, top ? Vec3f(0, 0, 1) : Vec3f(0, 0, -1), faces_at(mesh, pole)});
}

/// A tube of m rings of n vertices with two flat ends.
inline QuadMesh flat_tube(std::size_t m, std::size_t n, double radius = 1, double length = 4) {
    QuadMesh mesh = tube(m, n, radius, length);
    make_rim(mesh, m, n, false, radius);
    make_rim(mesh, m, n, true, radius);
    return mesh;
}

/// A cone on a flat base of n vertices, its tip at height h.
inline QuadMesh cone(std::size_t n, double h, double radius = 1) {
    QuadMesh mesh;
    for (std::size_t j = 0; j < n; ++j) {
        const double a = 2 * std::numbers::pi * double(j) / double(n);
        mesh.positions.emplace_back(float(radius * std::cos(a)), float(radius * std::sin(a)), 0.0f);
    }
    const std::uint32_t bottom = index_of(n), tip = bottom + 1;
    mesh.positions.emplace_back(0.0f, 0.0f, 0.0f);
    mesh.positions.emplace_back(0.0f, 0.0f, float(h));
    for (const auto& [a, b] : ring_edges(0, n)) {
        mesh.add_face(std::array{bottom, b, a});
        mesh.add_face(std::array{tip, a, b});
    }
    mesh.features.poles = {bottom, tip};
    mesh.features.corners = {tip};
    mesh.features.circles = {{Vec3f::Zero(), Vec3f::UnitZ(), float(radius), ring_edges(0, n)}};
    for (const MeshEdge& edge : ring_edges(0, n)) mesh.features.creases.push_back({edge, 10});
    mesh.features.planes = {{Vec3f::Zero(), Vec3f(0, 0, -1), faces_at(mesh, bottom)}};
    return mesh;
}

/// The box [0, 2] x [0, 3] x [0, 5] with all its features: rings of eight up its sides, a pole in the middle
/// of either end.
inline QuadMesh box() {
    const float x[] = {0, 1, 2, 2, 2, 1, 0, 0}, y[] = {0, 0, 0, 1.5f, 3, 3, 3, 1.5f};
    QuadMesh mesh = tube(3, 8);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 8; ++j) mesh.positions[8 * i + j] = {x[j], y[j], 2.5f * float(i)};
    mesh.positions[24] = {1, 1.5f, 0};
    mesh.positions[25] = {1, 1.5f, 5};
    for (std::size_t first : {0u, 16u})
        for (const MeshEdge& edge : ring_edges(first, 8)) mesh.features.creases.push_back({edge, 10});
    for (std::uint32_t j = 0; j < 8; j += 2) {
        mesh.features.corners.insert(mesh.features.corners.end(), {j, 16 + j});
        mesh.features.creases.push_back({{j, j + 8}, 10});
        mesh.features.creases.push_back({{j + 8, j + 16}, 10});
    }
    const Vec3f low(0, 0, 0), high(2, 3, 5);
    for (int axis = 0; axis < 3; ++axis)
        for (const bool far : {false, true}) {
            Plane plane{far ? high : low, (far ? 1.0f : -1.0f) * Vec3f::Unit(axis), {}};
            for (std::size_t f = 0; f < mesh.face_count(); ++f) {
                const auto face = mesh.face(f);
                if (std::ranges::all_of(
                        face, [&](std::uint32_t v) { return mesh.positions[v][axis] == plane.point[axis]; }))
                    plane.faces.push_back(index_of(f));
            }
            mesh.features.planes.push_back(plane);
        }
    return mesh;
}

/// Moves the control points until their limits are where `target` has them.
template <class Target>
inline void fit(QuadMesh& mesh, const Target& target) {
    const auto stencils = build_limit_stencils(mesh);
    ASSERT_TRUE(stencils);
    std::vector<Vec3> targets, control;
    for (const Vec3f& p : mesh.positions) control.push_back(p.cast<double>());
    for (const Vec3f& p : mesh.positions) targets.push_back(target(p));
    // Vertices that stay have no other limit than themselves.
    std::vector<Vec3> limit(control.size());
    limit_positions(*stencils, std::span<const Vec3>(control), limit);
    for (std::size_t v = 0; v < limit.size(); ++v)
        if (limit[v] == control[v]) targets[v] = control[v];
    fit_to_limit(*stencils, targets, control);
    for (std::size_t v = 0; v < control.size(); ++v) mesh.positions[v] = control[v].cast<float>();
}

/// A sphere of n meridians, or two halves of it with a tube of a length between them, with poles.
inline QuadMesh capsule(int n, int straight) {
    const int k = std::max(2, int(std::lround(n / 4.0)));
    std::vector<Vec2> profile;  // radius, height
    for (int i = -k + 1; i < k; ++i) {
        const double a = i * std::numbers::pi / (2 * k);
        if (i == 0)
            for (int s = 0; s < straight; ++s) profile.emplace_back(1, s);
        profile.emplace_back(std::cos(a), std::sin(a) + (i >= 0 ? straight : 0));
    }
    QuadMesh mesh = tube(profile.size(), std::size_t(n));
    for (std::size_t i = 0; i < profile.size(); ++i)
        for (std::size_t j = 0; j < std::size_t(n); ++j) {
            Vec3f& p = mesh.positions[i * std::size_t(n) + j];
            p.head<2>() *= float(profile[i].x());
            p.z() = float(profile[i].y());
        }
    mesh.positions[mesh.features.poles[0]] = {0, 0, -1};
    mesh.positions[mesh.features.poles[1]] = {0, 0, float(straight + 1)};
    return mesh;
}

}  // namespace sinew::shapes
