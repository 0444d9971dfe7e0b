/// @file balance.h
/// How far the smooth surface is outside the joints it belongs to, on the mean over the faces round a vertex.
///
/// Where round cones meet, a smooth surface that passes through the ideal surface at its vertices swells between them: the
/// faces there are as large as the joint. A vertex that stands where the weighted mean of the distances at its own limit
/// and at the middles of its faces is zero leaves the least of both, as in squared distance minimisation
/// (K.-S. D. Cheng, W. Wang et al., "Fitting subdivision surfaces to unorganized point data using SDM", Pacific Graphics
/// 2004), of which this is a relaxation vertex by vertex.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sinew/sqm/bridge/bridge.h"

namespace sinew::sqm {

class Balance {
  public:
    /// @param joint  vertex -> the joint that it is balanced by; -1: it is not
    Balance(const Parts& parts, const QuadMesh& mesh, std::vector<std::int32_t> joint);

    bool balances(std::size_t vertex) const { return joint_[vertex] >= 0; }

    /// Measures the middles of all faces that touch balanced vertices.
    /// @param control,limit  by vertex: control points, and where the smooth surface has them
    void measure(std::span<const Vec3> control, std::span<const Vec3> limit);

    /// The weighted mean of the signed distances round a balanced vertex, after measure(); above 0 outside.
    double mean_outside(std::size_t vertex, const Vec3& limit) const;

  private:
    struct Face {
        std::uint32_t face;
        std::array<std::int32_t, 2> joint{-1, -1};  ///< of its vertices; two where a bone is short
    };
    double distance(std::int32_t joint, const Vec3& place) const;

    const Parts& parts_;
    const QuadMesh& mesh_;
    std::vector<std::int32_t> joint_;
    std::vector<Face> faces_;
    std::vector<std::uint32_t> face_first_, faces_of_;  ///< vertex -> its faces, as indices in faces_
    std::vector<double> outside_;                       ///< by faces_
};

}  // namespace sinew::sqm
