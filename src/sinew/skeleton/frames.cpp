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

Surroundings surroundings_of(const Document& document, const std::vector<Bone>& bones,
                             const Adjacency& neighbours, std::int32_t node) {
    const auto other = [&](std::int32_t b) { return bones[b][0] == node ? bones[b][1] : bones[b][0]; };
    const auto to = [&](std::int32_t i) {
        return Vec3(document.nodes[i].position - document.nodes[node].position);
    };
    Surroundings around{.degree = neighbours.degree(node)};
    const auto at = neighbours.bones(node);
    const std::int32_t parent = document.nodes[node].parent;
    if (around.degree == 0 || (parent < 0 && around.degree > 2)) return around;
    const std::int32_t first = parent < 0 ? other(at[0]) : parent;
    const double sense = parent < 0 ? 1 : -1;  // away from a root, towards any other node
    around.first = around.second = unit(sense * to(first), Vec3::UnitZ());
    if (around.degree == 2)
        around.second = unit(-sense * to(other(at[0]) == first ? other(at[1]) : other(at[0])), around.first);
    return around;
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

bool takes_rotation(const Node& node, std::int32_t degree) {
    const bool body = node.type == NodeType::cube || node.type == NodeType::ball;
    return degree == 0 || degree > 2 || (node.parent < 0 && body);
}

Mat3 local_frame(const Node& node, const Surroundings& around) {
    const bool turns = takes_rotation(node, around.degree);
    if (turns && node.rotation)
        return node.rotation->normalized().toRotationMatrix() * frame_about(Vec3::UnitZ(), node.roll);
    if (turns && (node.parent < 0 || around.degree == 0 || node.type == NodeType::cube))
        return frame_about(Vec3::UnitZ(), node.roll);
    const Vec3 sum = around.first + around.second;
    const bool bisects = around.degree == 2 && sum.norm() > 1e-6;
    return frame_about(bisects ? Vec3(sum.normalized()) : around.first, node.roll);
}

Mat3 local_frame(const Document& document, const std::vector<Bone>& bones, const Adjacency& neighbours,
                 std::int32_t i) {
    return local_frame(document.nodes[i], surroundings_of(document, bones, neighbours, i));
}

}  // namespace sinew
