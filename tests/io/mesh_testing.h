/// @file mesh_testing.h
/// What the tests of the mesh formats share.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <bit>
#include <cmath>

#include "mesh/shapes.h"
#include "sinew/base/result.h"
#include "sinew/mesh/topology.h"

namespace sinew {

inline bool same_bits(const Vec3f& a, const Vec3f& b) {
    for (int i = 0; i < 3; ++i)
        if (std::bit_cast<std::uint32_t>(a[i]) != std::bit_cast<std::uint32_t>(b[i])) return false;
    return true;
}

inline void expect_same_mesh(const QuadMesh& read, const QuadMesh& written) {
    ASSERT_EQ(read.vertex_count(), written.vertex_count());
    EXPECT_EQ(read.face_offsets, written.face_offsets);
    EXPECT_EQ(read.corners, written.corners);
    for (std::size_t v = 0; v < read.vertex_count(); ++v)
        ASSERT_TRUE(same_bits(read.positions[v], written.positions[v])) << "vertex " << v;
}

/// The text of the error; empty where there is none.
template <class T>
std::string error_text(const Result<T>& result) {
    return result ? "" : result.error().text();
}

/// Calls read(prefix) for every prefix of a good file: it must give a sound mesh or name the file, and never
/// crash. Returns how many prefixes were read as meshes.
template <class Read>
std::size_t read_prefixes(std::string_view bytes, const Read& read) {
    std::size_t sound = 0;
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        // A copy of its own, so that a sanitizer sees a read past its end.
        const std::vector<char> prefix(bytes.begin(), bytes.begin() + std::ptrdiff_t(size));
        const Result<QuadMesh> mesh = read(std::string_view(prefix.data(), prefix.size()));
        if (mesh) {
            ++sound;
            EXPECT_TRUE(well_formed(*mesh));
        } else {
            EXPECT_EQ(mesh.error().file, "cut") << mesh.error().text();
        }
    }
    return sound;
}

/// Any finite float, each bit pattern alike likely: most are far from 1.
inline rc::Gen<float> any_float() {
    return rc::gen::map(rc::gen::arbitrary<std::uint32_t>(), [](std::uint32_t bits) {
        const float value = std::bit_cast<float>(bits);
        return std::isfinite(value) ? value : 0.0f;
    });
}

/// A mesh of random positions and polygons, well formed and else of no sense.
inline rc::Gen<QuadMesh> any_mesh(std::uint32_t most_corners = 7) {
    return rc::gen::exec([most_corners] {
        QuadMesh mesh;
        const auto coordinates = *rc::gen::nonEmpty(rc::gen::container<std::vector<float>>(any_float()));
        for (std::size_t i = 0; i < coordinates.size(); ++i)
            mesh.positions.emplace_back(coordinates[i], coordinates[i / 2],
                                        -coordinates[coordinates.size() - 1 - i]);
        const auto vertex = rc::gen::inRange<std::uint32_t>(0, shapes::index_of(mesh.vertex_count()));
        const auto faces = *rc::gen::inRange(1, 20);
        for (int f = 0; f < faces; ++f)
            mesh.add_face(*rc::gen::container<std::vector<std::uint32_t>>(
                *rc::gen::inRange<std::uint32_t>(3, most_corners + 1), vertex));
        return mesh;
    });
}

}  // namespace sinew
