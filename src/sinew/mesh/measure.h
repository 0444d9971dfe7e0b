/// @file measure.h
/// The numbers people judge a mesh by: kinds of faces, valences, sizes, and how good the quads are.
#pragma once

#include "sinew/mesh/topology.h"
#include "sinew/mesh/validate.h"

namespace sinew {

/// Least, mean and greatest of some numbers; all zero where there are none.
struct Spread {
    double min = 0;
    double mean = 0;
    double max = 0;
    std::int64_t count = 0;
};

struct Measures {
    std::int64_t triangles = 0;
    std::int64_t quads = 0;
    std::int64_t ngons = 0;  ///< faces of five corners and more

    /// A pole is a vertex with nothing but triangles round it, each of whose neighbours has another kind of
    /// face too.
    std::int64_t poles = 0;
    std::int64_t stray_triangles = 0;  ///< triangles that are not in the fan of a pole
    std::int64_t irregular_vertices =
        0;                         ///< vertices with faces and a valence other than 4, poles among them
    std::int64_t max_valence = 0;  ///< edges at a vertex, poles left out
    std::int64_t max_pole_valence = 0;

    Vec3 low = Vec3::Zero();  ///< bounding box of all vertices
    Vec3 high = Vec3::Zero();
    double area = 0;    ///< sum of the lengths of the faces' vector areas
    double volume = 0;  ///< signed: positive where faces look outwards; of meaning if the mesh is closed
    IndexFaults
        zero_area;  ///< faces no higher, over their longest edge, than the rounding of their coordinates

    Spread edge_length;
    /// The scaled Jacobian of quads: the least, over the corners, of the sine of the angle there, negative
    /// where the corner turns against the face (Knupp 2000). 1 for a rectangle, at most 0 for a quad folded
    /// or bent inwards.
    Spread quad_quality;
    IndexFaults folded_quads;  ///< quads of quality 0 or less
    Spread quad_aspect;        ///< longest over shortest side; quads with a side of no length left out
};

/// The scaled Jacobian of one quad.
double quad_quality(const QuadMesh& mesh, std::size_t face);

/// Measures a mesh in linear time. It must be well formed; vertices that are not finite spoil sizes, no more.
/// The same on any number of threads.
Measures measure(const QuadMesh& mesh);
Measures measure(const QuadMesh& mesh, const Topology& topology);

}  // namespace sinew
