#include "sinew/sqm/fit/fit_round_ends.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sinew/mesh/limit.h"
#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

/// A stick along x, from 0 to `length`, of radius 1, as placed and with its ends fitted.
struct Stick {
    Stages s;
    std::vector<Vec3> placed, fitted;
    std::array<bool, 2> round{};

    Stick(double length, int sides, NodeType end)
        : Stick(
              [&] {
                  Document d = chain(std::vector<Vec3>{{0, 0, 0}, {length, 0, 0}}, 1);
                  d.nodes[1].type = end;
                  return d;
              }(),
              sides) {}
    Stick(const Document& document, int sides) : s(document, sides) {
        s.stations = make_stations(s.skeleton, s.network, s.polyhedra, s.refinement, s.surfaces, s.points,
                                   {.support = true});
        Bridge b = bridge(s.parts()).value();
        finish(s, false, b);
        for (const Vec3f& p : b.mesh.positions) placed.push_back(p.cast<double>());
        fitted = placed;
        round = fit_round_ends(s.parts(), b, 0, ring_fit_radius(sides) / ring_limit_radius(sides), fitted);
    }
};

TEST(FitRoundEnds, MovesRoundEndsAlone) {
    const Stick stick(8, 6, NodeType::hemisphere);
    EXPECT_EQ(stick.round, (std::array{true, false}));
    int moved = 0;
    for (std::size_t v = 0; v < stick.placed.size(); ++v)
        if (stick.placed[v].x() > 1e-6)
            EXPECT_EQ(stick.fitted[v], stick.placed[v]) << v;
        else
            moved += stick.fitted[v] != stick.placed[v];
    EXPECT_GT(moved, 6);
}

TEST(FitRoundEnds, KeepsEveryRingRoundTheAxisAndBeyondItsPlace) {
    for (const int sides : {4, 5, 6, 8, 12}) {
        const Stick stick(8, sides, NodeType::sphere);
        EXPECT_EQ(stick.round, (std::array{true, true}));
        Vec3 sum = Vec3::Zero();
        for (std::size_t v = 0; v < stick.placed.size(); ++v) {
            const Vec3 &from = stick.placed[v], &to = stick.fitted[v];
            // A spline runs inside its control points: these are further out than the ball, in the same plane
            // through the axis.
            const double end = from.x() < 4 ? 0 : 8;
            EXPECT_GE((to - Vec3(end, 0, 0)).norm(), (from - Vec3(end, 0, 0)).norm() - 1e-9) << sides;
            EXPECT_NEAR(from.y() * to.z(), from.z() * to.y(), 1e-6) << sides;
            sum += to - Vec3(4, 0, 0);
        }
        EXPECT_NEAR(sum.norm(), 0, 1e-4) << "both ends alike, " << sides;
    }
}

TEST(FitRoundEnds, MeetOnASphere) {
    const Stick stick(0.4, 8, NodeType::sphere);
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p : stick.fitted) {
        EXPECT_LT((p - Vec3(0.2, 0, 0)).norm(), 1.6);
        sum += p - Vec3(0.2, 0, 0);
    }
    EXPECT_LT(sum.norm() / static_cast<double>(stick.fitted.size()), 0.02) << "neither overshoots the other";
}

/// Each end is fitted to the two rings below it. With one ring between both, the second is the other end's,
/// and fitting one after the other would leave them unlike.
TEST(FitRoundEnds, AreFittedTogetherWhereOneRingIsBetweenThem) {
    for (const double half : {0.05, 0.1, 0.15, 0.2}) {
        const Stick stick(chain(std::vector<Vec3>{{0, 0, 0}, {half, 0, 0}, {2 * half, 0, 0}}, 1), 8);
        const std::vector<Station> rings = stick.s.rings(0);
        EXPECT_EQ(std::count_if(rings.begin(), rings.end(), [](auto& r) { return r.fit != RingFit::cap; }),
                  1);
        for (const Vec3& p : stick.fitted) {
            const Vec3 other_end(2 * half - p.x(), p.y(), p.z());
            double nearest = 1;
            for (const Vec3& q : stick.fitted) nearest = std::min(nearest, (other_end - q).norm());
            EXPECT_LT(nearest, 0.001) << half;
        }
    }
}

}  // namespace
}  // namespace sinew::sqm
