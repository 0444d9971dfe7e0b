#include "sinew/sqm/rings/ring_support.h"

#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

/// Distances from a place of the rings that are held, nearest first.
std::vector<double> held_from(const Document& d, const Vec3& place, bool support = true) {
    const Stages s(d);
    std::vector<double> distance;
    for (const Station& ring : make_stations(s.skeleton, s.network, s.polyhedra, s.refinement, s.surfaces,
                                             s.points, {.support = support})
                                   .stations)
        if (ring.fit == RingFit::held) distance.push_back((ring.centre - place).norm());
    std::sort(distance.begin(), distance.end());
    return distance;
}

TEST(RingSupport, StandsOnBothArmsOfASharpBendOnly) {
    const Vec3 bend(6, 0, 0);
    const auto sharp = held_from(chain(std::vector<Vec3>{{0, 0, 0}, bend, {6, 6, 0}}, 0.5), bend);
    const auto gentle = held_from(chain(std::vector<Vec3>{{0, 0, 0}, bend, {12, 0.5, 0}}, 0.5), bend);
    EXPECT_EQ(sharp.size(), gentle.size() + 4);
    ASSERT_GE(sharp.size(), 4u);
    EXPECT_NEAR(sharp[0], sharp[1], 1e-9);
    EXPECT_NEAR(sharp[2], sharp[3], 1e-9);
    EXPECT_LT(sharp[3], 2);
}

/// A cubic spline through nodes a bone's length apart cuts a bend by a sixth of the second difference.
TEST(RingSupport, StandsWhereASmoothCurveWouldCutTheBendDeep) {
    for (const double radius : {0.2, 0.5, 1.0, 2.0})
        for (const double angle : {0.1, 0.3, 0.6}) {  // radians
            const Vec3 bend(8, 0, 0), end(8 + 8 * std::cos(angle), 8 * std::sin(angle), 0);
            const auto held = held_from(chain(std::vector<Vec3>{{0, 0, 0}, bend, end}, radius), bend);
            const auto near = std::count_if(held.begin(), held.end(), [&](double d) { return d < 4; });
            const double cut = 8.0 / 6 * 2 * std::sin(angle / 2);
            EXPECT_EQ(near > 0, cut > 0.25 * radius) << radius << ' ' << angle;
        }
}

TEST(RingSupport, HoldsTheBaseOfATip) {
    Document d = chain(std::vector<Vec3>{{0, 0, 0}, {6, 0, 0}, {9, 0, 0}}, 1);
    d.nodes[2].type = NodeType::cone;
    const auto held = held_from(d, {6, 0, 0});
    ASSERT_FALSE(held.empty());
    EXPECT_NEAR(held[0], 0, 1e-9);
}

TEST(RingSupport, IsThereWhereItIsAskedForOnly) {
    EXPECT_TRUE(
        held_from(chain(std::vector<Vec3>{{0, 0, 0}, {6, 0, 0}, {6, 6, 0}}, 0.5), {6, 0, 0}, false).empty());
}

}  // namespace
}  // namespace sinew::sqm
