#include "sinew/sqm/fit/balance.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

#include "sinew/sqm/surface/blend.h"

namespace sinew::sqm {
namespace {

/// Of what is outside the round cones, beside what is inside: a swelling is seen as a lump, a hollow as a fillet. With 1 the
/// worst percent of the area of 38 skeletons of others swells by 0.15 / 0.69 r (median, worst), with 4 by 0.14 / 0.49, with 8
/// by 0.12 / 0.41, but hollows grow by half.
constexpr double weight_outside = 4;
/// Of a vertex's own place on the smooth surface, beside the middle of a face round it: with 1 a limb is dented by 2.8 % of
/// its radius beside a branch, with 2 by less than 2.5 %; 8 lets the worst swelling grow from 0.49 to 0.59 r.
constexpr double weight_of_own = 2;
/// The middle of a face of the smooth surface: so much of the mean of its control points, the rest of that of their limits.
/// Along one direction of a uniform cubic B-spline it is exactly this; across both directions up to the product of
/// both second differences.
constexpr double share_of_control = 0.75;

}  // namespace

Balance::Balance(const Parts& parts, const QuadMesh& mesh, std::vector<std::int32_t> joint)
    : parts_(parts), mesh_(mesh), joint_(std::move(joint)), face_first_(joint_.size() + 1, 0) {
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        Face face{static_cast<std::uint32_t>(f)};
        for (const std::uint32_t v : mesh.face(f)) {
            if (joint_[v] < 0) continue;
            (face.joint[0] < 0 || face.joint[0] == joint_[v] ? face.joint[0] : face.joint[1]) = joint_[v];
            ++face_first_[v + 1];
        }
        if (face.joint[0] >= 0) faces_.push_back(face);
    }
    for (std::size_t v = 0; v < joint_.size(); ++v) face_first_[v + 1] += face_first_[v];
    faces_of_.resize(face_first_.back());
    std::vector<std::uint32_t> next(face_first_.begin(), face_first_.end() - 1);
    for (std::uint32_t i = 0; i < faces_.size(); ++i)
        for (const std::uint32_t v : mesh.face(faces_[i].face))
            if (joint_[v] >= 0) faces_of_[next[v]++] = i;
    outside_.assign(faces_.size(), 0);
}

double Balance::distance(std::int32_t joint, const Vec3& place) const {
    const Vec3& centre = parts_.skeleton.position[parts_.network.joint_node[joint]];
    return blended_distance(parts_.network, parts_.surfaces, joint, place - centre);
}

void Balance::measure(std::span<const Vec3> control, std::span<const Vec3> limit) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, faces_.size(), 512), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const auto face = mesh_.face(faces_[i].face);
            Vec3 sum = Vec3::Zero();
            for (const std::uint32_t v : face)
                sum += share_of_control * control[v] + (1 - share_of_control) * limit[v];
            const Vec3 middle = sum / static_cast<double>(face.size());
            outside_[i] = std::numeric_limits<double>::infinity();
            for (const std::int32_t joint : faces_[i].joint)
                if (joint >= 0) outside_[i] = std::min(outside_[i], distance(joint, middle));
        }
    });
}

double Balance::mean_outside(std::size_t vertex, const Vec3& limit) const {
    double sum = 0, weights = 0;
    const auto add = [&](double outside, double share) {
        const double weight = share * (outside > 0 ? weight_outside : 1);
        sum += weight * outside;
        weights += weight;
    };
    add(distance(joint_[vertex], limit), weight_of_own);
    for (std::uint32_t i = face_first_[vertex]; i < face_first_[vertex + 1]; ++i)
        add(outside_[faces_of_[i]], 1);
    return sum / weights;
}

}  // namespace sinew::sqm
