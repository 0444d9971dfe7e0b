#include "sinew/render/mesh_buffers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "render/shapes.h"

namespace sinew {
namespace {

Vec3f position(const MeshVertex& v) { return {v.position[0], v.position[1], v.position[2]}; }

/// Six times the volume inside: positive where all triangles are counter-clockwise from outside.
double signed_volume(const MeshBuffers& buffers) {
    double volume = 0;
    for (std::size_t t = 0; t < buffers.triangles.size(); t += 3) {
        const auto at = [&](std::size_t i) {
            return position(buffers.vertices[buffers.triangles[t + i]]).cast<double>().eval();
        };
        volume += at(0).dot(at(1).cross(at(2)));
    }
    return volume / 6;
}

TEST(MeshBuffers, HaveAVertexACornerAndTwoTrianglesAQuad) {
    const MeshBuffers buffers = mesh_buffers(shapes::box({1, 1, 1}, {1, 2, 3}));
    EXPECT_EQ(buffers.vertices.size(), 24u);
    EXPECT_EQ(buffers.triangles.size(), 36u);
    EXPECT_NEAR(signed_volume(buffers), 48, 1e-4);
    EXPECT_EQ(buffers.bounds.min(), Vec3f(0, -1, -2));
    EXPECT_EQ(buffers.bounds.max(), Vec3f(2, 3, 4));
}

TEST(MeshBuffers, PolygonsOfManySidesAreFansWithTheSameArea) {
    QuadMesh hexagon;
    for (int i = 0; i < 6; ++i)
        hexagon.positions.emplace_back(std::cos(float(i) * std::numbers::pi_v<float> / 3), 0,
                                       std::sin(float(i) * std::numbers::pi_v<float> / 3));
    hexagon.add_face(std::array<std::uint32_t, 6>{0, 1, 2, 3, 4, 5});
    const MeshBuffers buffers = mesh_buffers(hexagon);
    double area = 0;
    for (std::size_t t = 0; t < buffers.triangles.size(); t += 3) {
        const auto at = [&](std::size_t i) { return position(buffers.vertices[buffers.triangles[t + i]]); };
        area -= (at(1) - at(0)).cross(at(2) - at(0)).y() / 2;
    }
    EXPECT_NEAR(area, 1.5 * std::sqrt(3.0), 1e-5);
}

/// Along a diagonal the place in the face is in its inside, along a side it is on its rim.
TEST(MeshBuffers, DiagonalsAreNoEdges) {
    for (const QuadMesh& mesh : {shapes::box({0, 0, 0}, {1, 1, 1}), shapes::sphere({0, 0, 0}, 1, 8)}) {
        const MeshBuffers buffers = mesh_buffers(mesh);
        std::size_t sides = 0, diagonals = 0;
        for (std::size_t t = 0; t < buffers.triangles.size(); t += 3)
            for (std::size_t i = 0; i < 3; ++i) {
                const MeshVertex &a = buffers.vertices[buffers.triangles[t + i]],
                                 &b = buffers.vertices[buffers.triangles[t + (i + 1) % 3]];
                const int u = (a.u + b.u) / 2, v = (a.v + b.v) / 2;
                const bool on_rim = a.part == FacePart::quad ? u == 0 || u == 255 || v == 0 || v == 255
                                                             : u == 0 || v == 0 || 254 <= u + v;
                ++(on_rim ? sides : diagonals);
            }
        EXPECT_EQ(sides, mesh.corners.size());
        EXPECT_EQ(diagonals, 3 * (buffers.triangles.size() / 3) - mesh.corners.size());
    }
}

TEST(MeshBuffers, MarkVerticesOfOtherValencesThanFour) {
    EXPECT_EQ(mesh_buffers(shapes::box({0, 0, 0}, {1, 1, 1})).irregular.size(), 8u);
    EXPECT_EQ(mesh_buffers(shapes::sphere({0, 0, 0}, 1, 12)).irregular.size(), 2u) << "the poles";
    EXPECT_TRUE(mesh_buffers(shapes::grid(3)).irregular.empty()) << "a border is not irregular";
}

/// A flat polygon of its own, away from all others.
void add_polygon(QuadMesh& mesh, std::uint32_t sides, float x) {
    std::vector<std::uint32_t> face;
    for (std::uint32_t i = 0; i < sides; ++i) {
        const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(sides);
        face.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.emplace_back(x + std::cos(angle), std::sin(angle), 0);
    }
    mesh.add_face(face);
}

/// Faces are written in pieces, by many threads: each must find its place.
TEST(MeshBuffers, OfManyFacesAreThoseOfEachFaceInTheirOrder) {
    QuadMesh all;
    std::vector<MeshVertex> vertices;
    std::vector<std::uint32_t> triangles;
    for (std::uint32_t f = 0; f < 20000; ++f) {
        const std::uint32_t sides = f % 7 == 0 ? 3 : f % 1001 == 5 ? 5 + f % 4 : 4;
        QuadMesh one;
        add_polygon(one, sides, static_cast<float>(f));
        add_polygon(all, sides, static_cast<float>(f));
        const MeshBuffers buffers = mesh_buffers(one);
        for (const std::uint32_t i : buffers.triangles)
            triangles.push_back(static_cast<std::uint32_t>(vertices.size()) + i);
        vertices.insert(vertices.end(), buffers.vertices.begin(), buffers.vertices.end());
    }
    const MeshBuffers buffers = mesh_buffers(all);
    EXPECT_EQ(buffers.triangles, triangles);
    ASSERT_EQ(buffers.vertices.size(), vertices.size());
    EXPECT_EQ(std::memcmp(buffers.vertices.data(), vertices.data(), vertices.size() * sizeof(MeshVertex)), 0);
}

TEST(MeshBuffers, OfNothingAreEmpty) {
    const MeshBuffers buffers = mesh_buffers({});
    EXPECT_TRUE(buffers.vertices.empty());
    EXPECT_TRUE(buffers.bounds.isEmpty());
}

}  // namespace
}  // namespace sinew
