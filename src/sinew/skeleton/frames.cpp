#include "sinew/skeleton/frames.h"

#include <cmath>
#include <numbers>

#include "sinew/base/portable_math.h"

namespace sinew {
namespace {

/// Sine and cosine of degrees, exact at multiples of 90 and symmetric at those of 45.
std::pair<double, double> sine_cosine(double degrees) {
    double turn = std::fmod(degrees, 360.0);
    if (turn < 0) turn += 360;
    const int quarter = static_cast<int>(turn / 90);
    const double rest = turn - 90.0 * quarter;
    auto [s, c] = portable::sine_cosine(rest * std::numbers::pi / 180);
    if (rest == 0) s = 0, c = 1;
    if (rest == 45) s = c = std::sqrt(0.5);
    switch (quarter) {
        case 1:
            return {c, -s};
        case 2:
            return {-s, -c};
        case 3:
            return {-c, s};
        default:
            return {s, c};
    }
}

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
    if (roll == 0) return frame;
    const auto [sine, cosine] = sine_cosine(roll);
    Mat3 rolled = frame;
    rolled.col(0) = cosine * frame.col(0) + sine * frame.col(1);
    rolled.col(1) = cosine * frame.col(1) - sine * frame.col(0);
    return rolled;
}

Mat3 local_frame(const Document& document, const std::vector<Bone>& bones, const Adjacency& neighbours,
                 std::int32_t i) {
    const Node& node = document.nodes[i];
    const std::int32_t degree = neighbours.degree(i);
    const bool root = node.parent<0, branch = degree> 2;
    const bool turnable = node.type == NodeType::cube || node.type == NodeType::ball;
    if (node.rotation && (root || (turnable && branch)))
        return node.rotation->normalized().toRotationMatrix() * frame_about(Vec3::UnitZ(), node.roll);
    if (root || (branch && node.type == NodeType::cube)) return frame_about(Vec3::UnitZ(), node.roll);
    const Vec3 in = unit(node.position - document.nodes[node.parent].position, Vec3::UnitZ());
    if (degree != 2) return frame_about(in, node.roll);
    return frame_about(unit(in + unit(onwards(document, bones, neighbours, i), in), in), node.roll);
}

}  // namespace sinew
