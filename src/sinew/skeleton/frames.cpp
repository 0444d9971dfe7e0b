#include "sinew/skeleton/frames.h"

#include <cmath>
#include <numbers>

namespace sinew {
namespace {

Vec3 unit(const Vec3& v, const Vec3& otherwise) {
    const double length = v.stableNorm();
    return length > 0 && std::isfinite(length) ? Vec3(v / length) : otherwise;
}

/// Where the bone that is not the one to the parent leads: the way onwards from a connection.
Vec3 onwards(const Document& document, const std::vector<Bone>& bones, const Adjacency& neighbours,
             std::int32_t node) {
    const std::int32_t parent = document.nodes[node].parent;
    for (const std::int32_t b : neighbours.bones(node)) {
        const std::int32_t other = bones[b][0] == node ? bones[b][1] : bones[b][0];
        if (other != parent) return document.nodes[other].position - document.nodes[node].position;
    }
    return Vec3::Zero();
}

}  // namespace

Mat3 frame_about(const Vec3& z, double roll) {
    const Vec3 across = std::abs(z.x()) > 0.9 ? Vec3::UnitY() : Vec3::UnitX();
    Mat3 frame;
    frame.col(0) = (across - across.dot(z) * z).normalized();
    frame.col(1) = z.cross(frame.col(0));
    frame.col(2) = z;
    return frame * Eigen::AngleAxisd(roll * std::numbers::pi / 180, Vec3::UnitZ()).toRotationMatrix();
}

Mat3 local_frame(const Document& document, const std::vector<Bone>& bones, const Adjacency& neighbours,
                 std::int32_t i) {
    const Node& node = document.nodes[i];
    const std::int32_t degree = neighbours.degree(i);
    const bool root = node.parent<0, branch = degree> 2;
    const bool turnable = node.type == NodeType::cube || node.type == NodeType::ball;
    if (turnable && node.rotation && (root || branch))
        return node.rotation->normalized().toRotationMatrix() * frame_about(Vec3::UnitZ(), node.roll);
    if (root || (branch && node.type == NodeType::cube)) return frame_about(Vec3::UnitZ(), node.roll);
    const Vec3 in = unit(node.position - document.nodes[node.parent].position, Vec3::UnitZ());
    if (degree != 2) return frame_about(in, node.roll);
    return frame_about(unit(in + unit(onwards(document, bones, neighbours, i), in), in), node.roll);
}

}  // namespace sinew
