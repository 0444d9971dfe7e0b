#include "sinew/sqm/rings/stations.h"

#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

void expect_sound(const Stages& s) {
    ASSERT_EQ(std::ssize(s.stations.first), s.network.path_count() + 1);
    for (std::int32_t p = 0; p < s.network.path_count(); ++p) {
        const std::int32_t sides = s.refinement.path_sides[p];
        EXPECT_EQ(s.stations.angle_first[p + 1] - s.stations.angle_first[p], sides);
        EXPECT_GE(s.stations.far_shift[p], 0);
        EXPECT_LT(s.stations.far_shift[p], sides);
        for (std::int32_t i = s.stations.first[p]; i < s.stations.first[p + 1]; ++i) {
            const Station& ring = s.stations.stations[i];
            EXPECT_NEAR(ring.tangent.norm(), 1, 1e-9);
            EXPECT_NEAR(ring.x.norm(), 1, 1e-9);
            EXPECT_NEAR(ring.x.dot(ring.tangent), 0, 1e-9);
            EXPECT_GE(ring.bone, 0);
            EXPECT_GE(ring.along, 0);
            EXPECT_LE(ring.along, 1);
        }
    }
    EXPECT_EQ(s.stations.near_uneven.size(), s.stations.angle.size());
    EXPECT_EQ(s.stations.far_uneven.size(), s.stations.angle.size());
}

TEST(Stations, AreOneArrayForAllPaths) {
    property::Random random(17);
    expect_sound(Stages(random_tree(random, 5)));
    expect_sound(Stages(cube_of_struts()));
}

TEST(Stations, LoopsAndPairsHaveTheRingsThatKeepTheirEdgesApart) {
    Document loop = chain(fan(3), 0.9);  // nothing but joint, if it were not a loop
    loop.links = {{0, 2}};
    add(loop, 0, {3, 0, 0}, 0.9);
    const Stages s(loop);
    for (std::int32_t p = 0; p < s.network.path_count(); ++p)
        EXPECT_GE(s.ring_count(p), s.network.path_end[p][0].joint == s.network.path_end[p][1].joint ? 2 : 0);

    Document pair = chain(std::vector<Vec3>{{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {1, -1, 0}}, 0.9);
    pair.links = {{0, 3}};
    add(pair, 0, {-3, 0, 0}, 0.5);
    add(pair, 2, {5, 0, 0}, 0.5);
    const Stages t(pair);
    for (std::int32_t p = 0; p < t.network.path_count(); ++p)
        EXPECT_GE(t.ring_count(p), t.network.nodes(p).size() > 2 ? 1 : 0);
}

TEST(Stations, BeginWhereTheTubeHasLeftItsNeighbours) {
    for (const double angle : {0.15, 0.25, 0.4, 0.7}) {
        const Vec3 left(std::cos(angle), -std::sin(angle), 0), right(std::cos(angle), std::sin(angle), 0);
        const Stages s(star(std::vector<Vec3>{left, right, -Vec3::UnitX()}, 30, 1));
        for (std::int32_t p = 0; p < s.network.path_count(); ++p)
            for (std::int32_t i = s.stations.first[p]; i < s.stations.first[p + 1]; ++i) {
                const Station& ring = s.stations.stations[i];
                if (ring.shape == RingShape::follow || ring.centre.x() < 0) continue;
                EXPECT_GE(std::abs(ring.centre.y()), ring.half.x() * std::cos(angle) - 1e-6) << angle;
            }
    }
}

TEST(CornerColumn, CornersAreEvenlyApart) {
    for (std::int32_t sides = 4; sides <= 20; ++sides)
        for (std::int32_t first = 0; first < sides; ++first) {
            EXPECT_EQ(corner_column(first, 0, sides), first);
            for (int corner = 0; corner < 4; ++corner) {
                const std::int32_t step = (corner_column(first, (corner + 1) % 4, sides) -
                                           corner_column(first, corner, sides) + sides) %
                                          sides;
                EXPECT_GE(step, sides / 4);
                EXPECT_LE(step, sides / 4 + 1);
            }
        }
}

}  // namespace
}  // namespace sinew::sqm
