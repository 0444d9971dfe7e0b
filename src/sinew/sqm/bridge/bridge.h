/// @file bridge.h
/// Stage 3: tubes of quads between the rings, fans at their ends.
///
/// In: the network, its cells, their counts, the points at the joints and the rings along the paths. Out: the
/// vertex layout and all faces. No positions are compared and nothing is stitched: indices are known from the
/// counts. Vertices: first all joint points (JointPoints), then path after path its rings, then its poles,
/// then the poles of cells without a bone, then lone nodes. Cannot fail, but for more vertices than 32 bits
/// count.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sinew/base/progress.h"
#include "sinew/mesh/quad_mesh.h"
#include "sinew/sqm/bridge/lone_sphere.h"
#include "sinew/sqm/points/joint_points.h"
#include "sinew/sqm/rings/station.h"

namespace sinew::sqm {

struct Bridge {
    std::vector<std::uint32_t> path_vertex;  ///< path -> first vertex of its rings; paths + 1 entries
    std::vector<std::array<std::uint32_t, 2>>
        path_pole;  ///< path -> poles at its start and end; no_vertex if there is none
    /// Path -> its first face; paths + 1 entries. Faces of a path: the fan of its first pole if it has one, n
    /// quads for each two neighbouring rings (those of joints included), the fan of its last pole.
    std::vector<std::uint32_t> path_face;
    std::vector<std::int32_t> capped;  ///< cells without a bone
    std::uint32_t capped_pole = 0;     ///< the pole of capped[i] is capped_pole + i
    std::uint32_t lone_vertex = 0;     ///< lone node i has 26 vertices from lone_vertex + 26 i on
    QuadMesh mesh;                     ///< faces and poles; positions sized but not set
};
inline constexpr std::uint32_t no_vertex = ~std::uint32_t{0};

/// What the earlier stages made; all of it lives longer than this.
struct Parts {
    const Plain& skeleton;
    const Network& network;
    const Polyhedra& polyhedra;
    const Refinement& refinement;
    const JointSurfaces& surfaces;
    const JointPoints& points;
    const Stations& stations;
};

/// The vertex of column 0 of a ring: `station` counts through all paths.
inline std::uint32_t first_of_ring(const Parts& parts, const Bridge& bridge, std::int32_t path,
                                   std::int32_t station) {
    return bridge.path_vertex[path] +
           (station - parts.stations.first[path]) * parts.refinement.path_sides[path];
}

Result<Bridge> bridge(const Parts& parts, const Progress& progress = {});

/// The ring of the joint at one end of a path, in the path's sense; entry k is where column k ends.
void joint_ring_of_path(const Parts& parts, std::int32_t path, int end, std::vector<std::uint32_t>& ring);

}  // namespace sinew::sqm
