#include "sinew/skeleton/symmetric_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace sinew {
namespace {

bool same(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(a, b); }

/// Lines, in the frame, that a box or an ellipsoid of these extents may have along the symmetry's axis.
std::vector<Vec3> lines_of_symmetry(const Vec3& extents, const Symmetry& symmetry) {
    const bool mirror = symmetry.kind == Symmetry::Kind::mirror, half_turn = mirror || symmetry.count == 2;
    std::vector<Vec3> lines;
    for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const bool square = same(extents[i], extents[j]);
        const bool along_section = mirror && extents[k] == 0;  // tubes in the plane would leave it askew
        if ((half_turn || square) && !along_section) lines.push_back(Vec3::Unit(k));
        if (!half_turn || !square) continue;
        for (const double sign : {1.0, -1.0})
            lines.push_back((Vec3::Unit(i) + sign * Vec3::Unit(j)) / std::numbers::sqrt2);
    }
    if (symmetry.count == 3 && same(extents[0], extents[1]) && same(extents[1], extents[2]))
        for (const double x : {1.0, -1.0})
            for (const double y : {1.0, -1.0}) lines.push_back(Vec3(x, y, 1) / std::numbers::sqrt3);
    return lines;
}

}  // namespace

Mat3 symmetric_frame(const Mat3& frame, const Vec3& extents, const Symmetry& symmetry, bool upright) {
    constexpr double exact = 1 - 1e-14;
    const Vec3 axis = Vec3::Unit(symmetry.axis);
    if (upright && std::abs(frame.col(2).dot(axis)) > 1 - 1e-9) return frame;
    Vec3 nearest = Vec3::Zero();
    double best = -1;  // the cosine
    for (const Vec3& line : lines_of_symmetry(extents, symmetry)) {
        const Vec3 there = frame * line;
        const double cosine = std::abs(there.dot(axis));
        if (cosine > exact) return frame;
        const bool across_edges = line.cwiseAbs().maxCoeff() < 1 && symmetry.count != 3;
        const bool reachable =
            upright ? line.z() == 0 && std::abs(frame.col(2).dot(axis)) < 1e-6 : !across_edges;
        if (reachable && cosine > best + 1e-12) best = cosine, nearest = there;
    }
    if (nearest.isZero()) return frame;
    if (upright) nearest = (nearest - nearest.dot(frame.col(2)) * frame.col(2)).normalized();
    return Quat::FromTwoVectors(nearest.dot(axis) < 0 ? Vec3(-nearest) : nearest, axis).toRotationMatrix() *
           frame;
}

}  // namespace sinew
