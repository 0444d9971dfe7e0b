/// @file shapes.h
/// Meshes with known counts, areas and volumes, for tests and benchmarks.
#pragma once

#include <cmath>
#include <initializer_list>
#include <map>
#include <numbers>

#include "sinew/mesh/quad_mesh.h"

namespace sinew::shapes {

inline QuadMesh from_faces(std::vector<Vec3f> positions,
                           std::initializer_list<std::initializer_list<std::uint32_t>> faces) {
    QuadMesh mesh;
    mesh.positions = std::move(positions);
    for (const auto& face : faces) mesh.add_face({face.begin(), face.size()});
    return mesh;
}

/// The cube [0, 1]^3: vertex i has the bits of i as x, y, z.
inline QuadMesh cube() {
    std::vector<Vec3f> positions;
    for (int i = 0; i < 8; ++i) positions.emplace_back(float(i & 1), float(i >> 1 & 1), float(i >> 2 & 1));
    return from_faces(positions,
                      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

/// The hull of the six unit vectors.
inline QuadMesh octahedron() {
    return from_faces(
        {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
        {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
}

inline std::uint32_t index_of(std::size_t i) { return static_cast<std::uint32_t>(i); }

/// A torus of m rings of n vertices, of radii 3 and 1 round the z axis: m n vertices, m n quads.
inline QuadMesh torus(std::size_t m, std::size_t n) {
    QuadMesh mesh;
    for (std::size_t i = 0; i < m; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            const double a = 2 * std::numbers::pi * double(i) / double(m);
            const double b = 2 * std::numbers::pi * double(j) / double(n);
            const double r = 3 + std::cos(b);
            mesh.positions.emplace_back(float(r * std::cos(a)), float(r * std::sin(a)), float(std::sin(b)));
        }
    auto at = [&](std::size_t i, std::size_t j) { return index_of(i % m * n + j % n); };
    for (std::size_t i = 0; i < m; ++i)
        for (std::size_t j = 0; j < n; ++j)
            mesh.add_face(std::array{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    return mesh;
}

/// A tube of m >= 2 rings of n vertices along z from 0 to `length`, with fans to two poles (the last two
/// vertices).
inline QuadMesh tube(std::size_t m, std::size_t n, double radius = 1, double length = 4) {
    QuadMesh mesh;
    for (std::size_t i = 0; i < m; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            const double a = 2 * std::numbers::pi * double(j) / double(n);
            mesh.positions.emplace_back(float(radius * std::cos(a)), float(radius * std::sin(a)),
                                        float(length * double(i) / double(m - 1)));
        }
    const std::uint32_t bottom = index_of(m * n), top = bottom + 1;
    mesh.positions.emplace_back(0.0f, 0.0f, 0.0f);
    mesh.positions.emplace_back(0.0f, 0.0f, float(length));
    auto at = [&](std::size_t i, std::size_t j) { return index_of(i * n + j % n); };
    for (std::size_t j = 0; j < n; ++j) {
        mesh.add_face(std::array{bottom, at(0, j + 1), at(0, j)});
        for (std::size_t i = 0; i + 1 < m; ++i)
            mesh.add_face(std::array{at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
        mesh.add_face(std::array{top, at(m - 1, j), at(m - 1, j + 1)});
    }
    mesh.features.poles = {bottom, top};
    return mesh;
}

/// The surface of the cube [-1, 1]^3 with n x n quads a side: 6 n^2 + 2 vertices.
inline QuadMesh grid_cube(int n) {
    QuadMesh mesh;
    std::map<std::array<int, 3>, std::uint32_t> known;
    auto vertex = [&](std::array<int, 3> p) {
        const auto [found, fresh] = known.try_emplace(p, index_of(mesh.positions.size()));
        if (fresh)
            mesh.positions.emplace_back(float(2 * p[0] - n) / float(n), float(2 * p[1] - n) / float(n),
                                        float(2 * p[2] - n) / float(n));
        return found->second;
    };
    for (int axis = 0; axis < 3; ++axis)
        for (int side : {0, n})
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    std::array<std::uint32_t, 4> face{};
                    const int di[] = {0, 1, 1, 0}, dj[] = {0, 0, 1, 1};
                    for (int k = 0; k < 4; ++k) {
                        const int c = side ? k : 3 - k;  // seen from outside, counter-clockwise
                        std::array<int, 3> p{};
                        p[std::size_t(axis)] = side;
                        p[std::size_t((axis + 1) % 3)] = i + di[c];
                        p[std::size_t((axis + 2) % 3)] = j + dj[c];
                        face[std::size_t(k)] = vertex(p);
                    }
                    mesh.add_face(face);
                }
    return mesh;
}

/// The same blown up to the unit sphere.
inline QuadMesh sphere(int n) {
    QuadMesh mesh = grid_cube(n);
    for (Vec3f& p : mesh.positions) p.normalize();
    return mesh;
}

/// Puts a second mesh beside the first: its vertices and faces follow those of the first.
inline QuadMesh together(QuadMesh a, const QuadMesh& b) {
    const std::uint32_t shift = index_of(a.vertex_count());
    a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
    for (std::size_t f = 0; f < b.face_count(); ++f) {
        std::vector<std::uint32_t> face(b.face(f).begin(), b.face(f).end());
        for (std::uint32_t& v : face) v += shift;
        a.add_face(face);
    }
    return a;
}

inline QuadMesh moved(QuadMesh mesh, const Vec3f& by) {
    for (Vec3f& p : mesh.positions) p += by;
    return mesh;
}

/// The same mesh without some of its faces.
inline QuadMesh without_faces(const QuadMesh& mesh, std::initializer_list<std::size_t> left_out) {
    QuadMesh result;
    result.positions = mesh.positions;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        if (std::find(left_out.begin(), left_out.end(), f) == left_out.end()) result.add_face(mesh.face(f));
    return result;
}

/// The same mesh with one face turned over.
inline QuadMesh with_face_flipped(QuadMesh mesh, std::size_t face) {
    std::reverse(mesh.corners.begin() + mesh.face_offsets[face],
                 mesh.corners.begin() + mesh.face_offsets[face + 1]);
    return mesh;
}

}  // namespace sinew::shapes
