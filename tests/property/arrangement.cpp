#include "property/arrangement.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sinew/skeleton/graph.h"

namespace sinew::property {

namespace {

double least_angle(const std::vector<Vec3>& positions, const std::vector<double>& radii,
                   const std::vector<Bone>& bones) {
    std::vector<std::vector<Vec3>> directions(positions.size());
    double least = M_PI;
    for (const Bone& bone : bones)
        for (int end = 0; end < 2; ++end) {
            const Vec3 along = positions[bone[1 - end]] - positions[bone[end]];
            if (along.norm() <= 1e-9 * radii[bone[end]]) return 0;
            for (const Vec3& other : directions[bone[end]])
                least = std::min(least, std::atan2(other.cross(along).norm(), other.dot(along)));
            directions[bone[end]].push_back(along);
        }
    return least;
}

}  // namespace

bool is_plain(const Document& document) {
    return document.symmetry.kind == Symmetry::Kind::none &&
           std::all_of(document.nodes.begin(), document.nodes.end(), [](const Node& n) {
               return (n.type == NodeType::sphere || n.type == NodeType::cone) &&
                      n.section == Section::round && n.scale == std::array<double, 3>{1, 1, 1} &&
                      n.joint == 0;
           });
}

double least_angle(const Document& document) {
    std::vector<Vec3> positions;
    std::vector<double> radii;
    for (const Node& node : document.nodes) positions.push_back(node.position), radii.push_back(node.radius);
    return least_angle(positions, radii, bones_of(document));
}

double least_angle(const Plain& skeleton) {
    return least_angle(skeleton.position, skeleton.radius, skeleton.bones);
}

bool is_own_image(const Document& document, int axis) {
    using Place = std::array<double, 5>;
    const auto place = [&](std::int32_t i, double sign) {
        const Node& n = document.nodes[i];
        Vec3 p = n.position;
        p[axis] *= sign;
        return Place{p.x() + 0.0, p.y() + 0.0, p.z() + 0.0, n.radius, double(n.type == NodeType::cone)};
    };
    const auto places = [&](double sign) {
        std::vector<std::array<Place, 2>> all;
        for (std::int32_t i = 0; i < std::ssize(document.nodes); ++i)
            all.push_back({place(i, sign), place(i, sign)});
        for (const auto& [a, b] : bones_of(document))
            all.push_back(
                {std::min(place(a, sign), place(b, sign)), std::max(place(a, sign), place(b, sign))});
        std::sort(all.begin(), all.end());
        return all;
    };
    const auto drawn = places(1);
    return drawn == places(-1) && std::adjacent_find(drawn.begin(), drawn.end()) == drawn.end();
}

bool is_flat(const Document& document, int axis) {
    return std::all_of(document.nodes.begin(), document.nodes.end(),
                       [&](const Node& n) { return n.position[axis] == 0; });
}

}  // namespace sinew::property
