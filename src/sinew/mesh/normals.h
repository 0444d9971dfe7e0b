/// @file normals.h
/// Vertex normals, for shading.
#pragma once

#include "sinew/mesh/quad_mesh.h"

namespace sinew {

/// What a corner of a face adds to the normal of its vertex: sine over the product of the edge lengths there,
/// along the normal of the corner. It gives the exact normal where the neighbours lie on a sphere (N. Max,
/// "Weights for computing vertex normals from facet normals", 1999). Zero where an edge has no length.
/// @param next, previous  the edges of the face, away from the vertex
/// @param squares         the product of their squared lengths
template <class Vector>
Vector corner_normal(const Vector& next, const Vector& previous, typename Vector::Scalar squares) {
    return squares > 0 ? Vector(next.cross(previous) / squares) : Vector(Vector::Zero());
}
template <class Vector>
Vector corner_normal(const Vector& next, const Vector& previous) {
    return corner_normal(next, previous, next.squaredNorm() * previous.squaredNorm());
}

/// A unit normal a vertex, outward as the faces are: the sum over its corners. A vertex without faces, or whose
/// faces cancel each other, gets z. The mesh must be well formed (topology.h).
std::vector<Vec3f> vertex_normals(const QuadMesh& mesh);

}  // namespace sinew
