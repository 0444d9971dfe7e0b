/// @file limit_rings.h
/// Where subdivision takes a vertex in the limit, from the ring round it.
///
/// The ring of a vertex v: its edges' other ends e_i, counter-clockwise, and the means c_i of the corners of
/// its faces, c_i between e_i and e_i+1; as many of both round an inner vertex, one more edge than faces
/// round a boundary vertex. A step of subdivision maps the ring to the ring of the same vertex one level
/// finer: nothing further out matters.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace sinew {

/// Points are rows: of three coordinates, or of weights on the points one began with.
struct VertexRing {
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

    Eigen::RowVectorXd vertex;
    Rows edges;
    Rows means;
    std::vector<float> sharpness;  ///< of each edge, 0 where it is smooth; that of boundary edges infinite
    bool closed = true;            ///< is it an inner vertex?
};

/// One step of subdivision: `vertex` and `edges` become the new points, `means` those of the new faces. The
/// vertex is no corner but by its edges.
void refine_ring(VertexRing& ring);

/// Has it semi-sharp edges, which steps of subdivision make smooth?
bool fades(std::span<const float> sharpness);

struct RingWeights {
    double vertex = 1;
    std::vector<double> edges;
    std::vector<double> faces;
};

/// Weights of a smooth inner vertex of n edges: (n (n - 1) v + 2 sum e + 4 sum c) / (n (n + 5)). After one
/// step of Catmull-Clark this is the known mask (n^2 v + 4 sum e + sum f) / (n (n + 5)); written with the
/// means of the faces it holds for faces of any number of corners.
struct SmoothWeights {
    double vertex, edge, face;
    explicit SmoothWeights(double n)
        : vertex((n - 1) / (n + 5)), edge(2 / (n * (n + 5))), face(4 / (n * (n + 5))) {}
};

/// Weights of a vertex with sharp edges, exact for semi-sharp ones too: the ring is subdivided until only
/// edges of infinite sharpness are left, then 0 of them: the smooth mask; 1 (a dart): as subdivided on and
/// on; 2: (4 v + ends) / 6; 3 or more, or a corner: v. In a ring of more than 256 edges semi-sharp edges
/// count as smooth.
/// @param sharpness, closed  as in VertexRing
RingWeights limit_weights(std::span<const float> sharpness, bool closed, bool corner);

}  // namespace sinew
