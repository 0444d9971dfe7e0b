#include "sinew/sqm/rings/stations.h"

#include <algorithm>

#include "sinew/base/portable_math.h"
#include "sinew/sqm/chunks.h"
#include "sinew/sqm/rings/follow_rings.h"
#include "sinew/sqm/rings/joint_side.h"
#include "sinew/sqm/rings/path_angles.h"
#include "sinew/sqm/rings/path_rings.h"

namespace sinew::sqm {
namespace {

constexpr std::int32_t paths_a_task = 256;  // paths that one task takes

/// Whether a ring on the bone that leaves a joint is too wide for the joint's cell, from its centre.
bool is_crowded(const JointSide& side, const Station& ring) {
    constexpr double tight = 0.95;
    const double across = ring.half.maxCoeff();
    double height = (ring.centre - side.centre).dot(side.axis);
    if (ring.shape == RingShape::node) {  // leans over the bone
        const double cosine = std::abs(ring.tangent.dot(side.axis));
        height -= across * std::sqrt(std::max(0.0, 1 - cosine * cosine)) / std::max(0.2, cosine);
    }
    return across > tight * side.room * height;
}

void find_crowded(PathWork& w) {
    std::array<std::uint8_t, 2>& crowded = w.out.crowded[w.path];
    for (int end = 0; end < 2; ++end) {
        const JointSide& side = end == 0 ? w.near : w.far;
        if (side.room <= 0) continue;
        const std::int32_t bone = end == 0 ? 0 : w.bone_count() - 1, node = w.node(end == 0 ? 1 : bone);
        for (const Station& ring : w.rings)
            if (may_be_pulled(ring, w.bones[bone], node)) crowded[end] |= is_crowded(side, ring);
    }
}

/// @param least_rings  rings that the path must have, so that no two paths share an edge
void build(PathWork& w, std::int32_t path, std::int32_t least_rings) {
    w.path = path;
    w.nodes = w.n.nodes(path);
    w.bones = w.n.bones(path);
    w.closed = w.n.path_closed[path];
    w.plain = is_plain(w.s, w.n, path);
    if (const std::int32_t sides = w.r.path_sides[path]; sides != w.sides) {
        w.sides = sides;
        w.edge = 2 * portable::sine_cosine(M_PI / sides).sine;
        w.step = portable::sine_cosine(2 * M_PI / sides);
    }
    take_joint(w, w.n.path_end[path][0], false, w.near);
    take_joint(w, w.n.path_end[path][1], true, w.far);
    place_rings(w, false);
    if (std::ssize(w.rings) < least_rings) place_rings(w, true);
    find_crowded(w);
    find_angles(w);
    add_follow_rings(w);
}

/// Rings that each path must have: two on a path from a joint to itself, one on each of several between the
/// same two joints that has nodes to carry it; all others may do with none.
std::vector<std::uint8_t> least_rings(const Network& n) {
    std::vector<std::uint8_t> least(n.path_count(), 0);
    std::vector<std::array<std::int32_t, 3>> pairs;
    for (std::int32_t p = 0; p < n.path_count(); ++p) {
        const auto [a, b] = std::minmax(n.path_end[p][0].joint, n.path_end[p][1].joint);
        if (a == b && a >= 0) least[p] = 2;
        if (a != b && a >= 0) pairs.push_back({a, b, p});
    }
    std::sort(pairs.begin(), pairs.end());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto same = [&](std::size_t j) {
            return j < pairs.size() && pairs[j][0] == pairs[i][0] && pairs[j][1] == pairs[i][1];
        };
        const std::int32_t path = pairs[i][2];
        if (n.nodes(path).size() > 2 && (same(i + 1) || (i > 0 && same(i - 1)))) least[path] = 1;
    }
    return least;
}

/// All arrays but that of the rings, whose number only the work itself can tell.
Stations lay_out(const Network& n, const Refinement& r) {
    Stations all;
    const std::size_t paths = n.path_count();
    all.angle_first.resize(paths + 1);
    for (std::size_t p = 0; p < paths; ++p) all.angle_first[p + 1] = all.angle_first[p] + r.path_sides[p];
    for (std::vector<double>* array : {&all.angle, &all.near_uneven, &all.far_uneven})
        array->resize(all.angle_first.back());
    all.far_shift.resize(paths);
    all.corner.resize(paths);
    all.crowded.resize(paths);
    all.first.reserve(paths + 1);
    all.first.push_back(0);
    return all;
}

/// The rings of some paths.
struct Rings {
    std::vector<Station> rings;
    std::vector<std::int32_t> count;  ///< of each path
};

void append(const Rings& part, std::size_t paths, Stations& all) {
    if (all.stations.empty())  // room for all of them, judged by those of the first part
        all.stations.reserve(part.rings.size() * 1.1 * paths / part.count.size() + 64);
    all.stations.insert(all.stations.end(), part.rings.begin(), part.rings.end());
    for (const std::int32_t count : part.count) all.first.push_back(all.first.back() + count);
}

}  // namespace

Stations make_stations(const Plain& skeleton, const Network& network, const Polyhedra& polyhedra,
                       const Refinement& refinement, const JointSurfaces& surfaces, const JointPoints& points,
                       const StationOptions& options) {
    const std::vector<std::uint8_t> least = least_rings(network);
    Stations all = lay_out(network, refinement);
    for_chunks<Rings>(
        network.path_count(), paths_a_task,
        [&](Rings& part, std::int32_t begin, std::int32_t end) {
            part.rings.clear();
            part.count.clear();
            PathWork work{skeleton, network, polyhedra, refinement, surfaces, points, options, all};
            for (std::int32_t p = begin; p < end; ++p) {
                build(work, p, least[p]);
                part.rings.insert(part.rings.end(), work.rings.begin(), work.rings.end());
                part.count.push_back(static_cast<std::int32_t>(work.rings.size()));
            }
        },
        [&](const Rings& part) { append(part, network.path_count(), all); });
    return all;
}

}  // namespace sinew::sqm
