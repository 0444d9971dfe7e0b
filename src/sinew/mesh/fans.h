/// @file fans.h
/// Poles as subdivision meets them: closed triangle fans whose valence doubles at each level, so that no
/// crease grows in a tip (Myles and Peters, "Bi-3 C2 polar subdivision", SIGGRAPH 2009; docs/subdivision.md
/// derives the form used here).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sinew/mesh/sharpness.h"

namespace sinew {

struct PoleFan {
    std::uint32_t pole = 0;
    std::uint32_t first = 0;    ///< place in Fans::faces and Fans::ring
    std::uint32_t valence = 0;  ///< at least 3
    bool fixed = false;  ///< the pole stays and the fan runs straight into it: a corner, or inside a plane
};

/// Fan triangle j has the corners (pole, ring j, ring j + 1), from any of them on; both lists run
/// counter-clockwise seen from outside.
struct Fans {
    std::vector<PoleFan> fans;
    std::vector<std::uint32_t> faces;
    std::vector<std::uint32_t> ring;

    std::span<const std::uint32_t> faces_of(const PoleFan& fan) const {
        return {faces.data() + fan.first, fan.valence};
    }
    std::span<const std::uint32_t> ring_of(const PoleFan& fan) const {
        return {ring.data() + fan.first, fan.valence};
    }
};

/// The fans of those of `poles` that can be subdivided as poles, ascending. The others are ordinary
/// vertices: where the faces are not one closed fan of triangles, where another listed pole is a neighbour,
/// and where creases run into the pole without making it a corner. Fails for a pole that is no vertex.
Result<Fans> resolve_fans(const QuadMesh& mesh, const Topology& topology, const Sharpness& sharpness,
                          std::span<const std::uint32_t> poles);

/// Poles of a mesh that brings no list of them (from a file): vertices inside the mesh with nothing but
/// triangles round them, three at least, each of whose neighbours has another kind of face too. Ascending.
std::vector<std::uint32_t> detect_poles(const QuadMesh& mesh, const Topology& topology);

/// The pole rule. Spoke j of a smooth pole ends not in the pole but in q_j = pole + offset_j when its fan is
/// subdivided as Catmull-Clark quads (q_j, ring_j, ring_j+1, q_j+1). With the ring as mean m + Fourier modes
/// F1 + F2 + rest R: offset_j = -F2_j / 2 - R_j = m + F1_j + F2_j / 2 - ring_j. At valence 3 there is no mode
/// 2; at 4 it alternates.
/// @param offsets  as many as ring vertices
/// @return the mean m
Vec3 polar_offsets(std::span<const Vec3> ring, std::span<Vec3> offsets);

/// What Fourier mode 1 of the ring spans: two tangents of the limit surface at the pole; their cross product
/// is outward.
std::array<Vec3, 2> polar_tangents(std::span<const Vec3> ring);

}  // namespace sinew
