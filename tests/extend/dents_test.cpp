#include "skinning.h"

#include "sinew/mesh/measure.h"

namespace sinew {
namespace {

using namespace testing_types;

constexpr double tolerance = 0.05;

/// A dent on the unit ball: the direction of its axis, the radius of its opening, its depth.
struct Dent {
    Vec3 axis;
    double radius, depth;
};

Vec3 at_angle(double degrees) {
    const double a = degrees * M_PI / 180;
    return {std::sin(a), -std::cos(a), 0};
}

Document ball_with(const std::vector<Dent>& dents) {
    Document d;
    add(d, -1, {0, 0, 0}, 1, NodeType::ball);
    for (const Dent& dent : dents) add(d, 0, (1 + dent.depth) * dent.axis, dent.radius, NodeType::negative);
    return d;
}

/// Where a place is in a dent: 1 on its wall, which is half an ellipsoid.
double part_of(const Dent& dent, const Vec3& place) {
    const Vec3 from = place - dent.axis;
    const double up = from.dot(dent.axis);
    return std::hypot((from - up * dent.axis).norm() / dent.radius, up / dent.depth);
}

/// The dents and those on the way from each to those that it overlaps.
std::vector<Dent> swept(const std::vector<Dent>& dents) {
    constexpr int steps = 64;
    std::vector<Dent> all = dents;
    for (std::size_t a = 0; a < dents.size(); ++a)
        for (std::size_t b = a + 1; b < dents.size(); ++b) {
            if ((dents[a].axis - dents[b].axis).norm() > dents[a].radius + dents[b].radius) continue;
            for (int i = 1; i < steps; ++i) {
                const double share = double(i) / steps;
                all.push_back({((1 - share) * dents[a].axis + share * dents[b].axis).normalized(),
                               (1 - share) * dents[a].radius + share * dents[b].radius,
                               (1 - share) * dents[a].depth + share * dents[b].depth});
            }
        }
    return all;
}

struct Misfit {
    double wall = 0;   // of the vertices below half the depth, as a share of the dent's size
    double floor = 0;  // on the axes, as a share of the depth
};

Misfit misfit(const QuadMesh& mesh, const std::vector<Dent>& dents) {
    Misfit worst;
    const std::vector<Dent> groove = swept(dents);
    double shallow = dents[0].depth;
    for (const Dent& dent : dents) shallow = std::min(shallow, dent.depth);
    for (const Vec3f& p : mesh.positions) {
        const Vec3 place = p.cast<double>();
        if (1 - place.norm() < 0.5 * shallow) continue;
        double part = 1e9;
        for (const Dent& dent : groove) part = std::min(part, part_of(dent, place));
        if (part < 1.5) worst.wall = std::max(worst.wall, std::abs(part - 1));
    }
    for (const Dent& dent : dents) {
        double nearest = 1e9, depth = 0;
        for (const Vec3f& p : mesh.positions) {
            const Vec3 place = p.cast<double>();
            const double off = place.normalized().cross(dent.axis).norm();
            if (place.dot(dent.axis) > 0 && off < nearest) nearest = off, depth = 1 - place.dot(dent.axis);
        }
        worst.floor = std::max(worst.floor, std::abs(depth / dent.depth - 1));
    }
    return worst;
}

void expect_dents(const std::vector<Dent>& dents, const std::string& what) {
    const Document d = ball_with(dents);
    for (const bool smooth_surface : {false, true}) {
        const QuadMesh mesh = smooth_surface ? smooth(d) : solid(d).mesh;
        const Misfit off = misfit(mesh, dents);
        const std::string where = what + (smooth_surface ? ", subdivided" : "");
        const double radius = dents[0].radius, cap = 1 - std::sqrt(1 - radius * radius);
        const bool shallow = dents[0].depth<cap, steep = dents[0].depth> 1.2 * radius;
        if (!smooth_surface || (!shallow && !steep)) {
            EXPECT_LT(off.wall, tolerance) << where;
        }
        EXPECT_LT(off.floor, tolerance) << where;
        if (smooth_surface) {
            EXPECT_EQ(measure(mesh).folded_quads.count, 0u) << where;
        }
    }
}

TEST(Dents, AloneHaveTheRadiusAndTheDepthThatWereDrawn) {
    for (const double radius : {0.1, 0.2, 0.35, 0.5})
        for (const double depth : {0.05, 0.2, 0.5})
            expect_dents({{at_angle(0), radius, depth}},
                         "radius " + std::to_string(radius) + " depth " + std::to_string(depth));
}

TEST(Dents, ThatOverlapMakeAGrooveOfTheirRadiusAndDepth) {
    for (const double depth : {0.1, 0.25})
        for (const double apart : {9.0, 14.0, 20.0}) {
            const std::string what =
                " dents, " + std::to_string(apart) + " degrees, " + std::to_string(depth) + " deep";
            for (const int count : {2, 3, 5}) {
                std::vector<Dent> chain;
                for (int i = 0; i < count; ++i)
                    chain.push_back({at_angle((i - 0.5 * (count - 1)) * apart), 0.22, depth});
                expect_dents(chain, std::to_string(count) + what);
            }
            std::vector<Dent> three;
            for (const double turn : {0.0, 2.0, 4.0}) {
                const Vec3 side(std::cos(turn * M_PI / 3), 0, std::sin(turn * M_PI / 3));
                three.push_back(
                    {(0.58 * apart * M_PI / 180 * side - Vec3::UnitY()).normalized(), 0.22, depth});
            }
            expect_dents(three, "a cluster of 3" + what);
        }
}

}  // namespace
}  // namespace sinew
