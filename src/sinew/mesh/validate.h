/// @file validate.h
/// Is a mesh the surface of a body: well formed, finite, closed, a 2-manifold, oriented alike and outwards?
#pragma once

#include "sinew/mesh/topology.h"

namespace sinew {

/// Faulty places of one kind: how many there are, and the first few in ascending order.
template <class Place>
struct Faults {
    static constexpr std::size_t most_examples = 8;
    std::int64_t count = 0;
    std::vector<Place> examples;

    void add(const Place& place) {
        if (++count <= std::int64_t{most_examples}) examples.push_back(place);
    }
    void append(const Faults& later) {
        count += later.count;
        for (const Place& place : later.examples)
            if (examples.size() < most_examples) examples.push_back(place);
    }
    explicit operator bool() const { return count > 0; }
};
using IndexFaults = Faults<std::uint32_t>;
using EdgeFaults = Faults<MeshEdge>;

struct Validation {
    std::int64_t vertices = 0;  ///< loose ones too
    std::int64_t edges = 0;
    std::int64_t faces = 0;

    bool sound_offsets = true;  ///< the face offsets ascend from 0 to the number of corners
    IndexFaults bad_corners;    ///< corners that name no vertex
    IndexFaults non_finite;     ///< vertices with a coordinate that is nan or infinite

    // Where sound_offsets is false or bad_corners are many, what follows was not looked at and is zero.
    IndexFaults small_faces;           ///< faces of fewer than three corners
    IndexFaults repeating_faces;       ///< faces that name a vertex more than once
    IndexFaults loose_vertices;        ///< vertices of no face; they do no harm and count in no number below
    EdgeFaults boundary_edges;         ///< edges of one face
    EdgeFaults nonmanifold_edges;      ///< edges of three faces or more
    EdgeFaults flipped_edges;          ///< edges whose two faces run along them in the same direction
    IndexFaults nonmanifold_vertices;  ///< vertices whose faces are not one fan
    IndexFaults inward_components;     ///< lowest vertex of each component whose signed volume is negative
    std::int64_t components = 0;       ///< connected by edges
    std::int64_t euler = 0;  ///< vertices - edges + faces: 2 components - 2 handles if closed and manifold

    bool well_formed() const { return sound_offsets && !bad_corners; }
    bool finite() const { return !non_finite; }
    bool closed() const { return well_formed() && !boundary_edges; }
    bool manifold() const {
        return well_formed() && !small_faces && !repeating_faces && !nonmanifold_edges &&
               !nonmanifold_vertices;
    }
    bool oriented() const { return well_formed() && !flipped_edges; }
    bool outward() const { return oriented() && !inward_components; }
    /// Everything that holds for the surface of a body.
    bool solid() const { return finite() && closed() && manifold() && outward(); }
};

/// Looks at everything, in linear time; any content is fine.
Validation validate(const QuadMesh& mesh);
/// The same where the topology (of this mesh, which is well formed) is at hand.
Validation validate(const QuadMesh& mesh, const Topology& topology);

/// The component of each vertex, named by its lowest vertex. A loose vertex is one of its own.
std::vector<std::uint32_t> component_of_vertices(const Topology& topology);

}  // namespace sinew
