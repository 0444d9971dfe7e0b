/// @file finest_rings.h
/// The rings of the finest level, which has no tables of its own: its faces are read off the level before it.
#pragma once

#include "sinew/mesh/limit_rings.h"
#include "sinew/subdivide/finest.h"
#include "sinew/subdivide/rings.h"

namespace sinew {

/// A face seen from one of its slots: the neighbours along both edges there, and the mean of its corners.
struct SeenFace {
    std::uint32_t next = 0;
    std::uint32_t previous = 0;
    Vec3f mean = Vec3f::Zero();
};

/// Calls body(see), where see(slot) is the face of a slot of the finest level.
template <class Body>
void with_finest_faces(const Finest& finest, std::span<const Vec3f> positions, const Body& body) {
    if (finest.splits == 0) {
        const Polygons faces{finest.levels[0]};
        body([faces, positions](std::uint32_t slot) {
            const auto& corners = faces.level.corners;
            const std::uint32_t face = faces.face(slot), begin = faces.begin(face), end = faces.end(face);
            SeenFace seen{corners[faces.next(slot)], corners[faces.previous(slot)], Vec3f::Zero()};
            for (std::uint32_t s = begin; s < end; ++s) seen.mean += positions[corners[s]];
            seen.mean /= static_cast<float>(end - begin);
            return seen;
        });
    } else {
        const Level& level = finest.levels[finest.splits - 1];
        with_faces(level, [&](const auto& faces) {
            body([&level, &faces, positions](std::uint32_t slot) {
                const auto corners = finer_face(level, faces, slot >> 2);
                const Vec3f sum = (positions[corners[0]] + positions[corners[2]]) +
                                  (positions[corners[1]] + positions[corners[3]]);
                return SeenFace{corners[(slot + 1) & 3], corners[(slot + 3) & 3], sum / 4};
            });
        });
    }
}

/// A ring as the rules see it: with the sharpness of its edges, and with spokes of poles ending where the
/// pole rule has them end.
struct RuledRing {
    VertexRing points;                 ///< rows of three coordinates
    std::vector<std::uint32_t> ends;   ///< vertices at the edges' ends
    std::vector<std::uint32_t> slots;  ///< one for each face
};

/// Gathers rings of the finest level where the short way through for_each_ring does not do.
class FinestRings {
  public:
    FinestRings(const Finest& finest, std::span<const Vec3f> positions);

    RuledRing ring(std::uint32_t vertex) const;

    /// Offsets of all spokes of poles (zero at fixed ones), in the order of rules.fans.ring.
    std::span<const Vec3> offsets() const { return offsets_; }
    /// Vertices round poles that move, ascending.
    std::vector<std::uint32_t> round_poles() const;

  private:
    struct Place {
        std::uint32_t vertex, fan, spoke;
        auto operator<=>(const Place&) const = default;
    };

    void find_offsets(const PoleFan& fan);
    void gather(RuledRing& ring, std::uint32_t vertex) const;
    void sharpen(RuledRing& ring, std::uint32_t vertex) const;
    void move_spokes(RuledRing& ring, std::uint32_t vertex) const;

    const Finest& finest_;
    std::span<const Vec3f> positions_;
    std::vector<Vec3> offsets_;
    std::vector<Place> places_;  ///< where vertices are in the rings of poles, ascending
};

}  // namespace sinew
