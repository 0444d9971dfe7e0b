#include "sinew/sqm/rings/path_angles.h"

#include <algorithm>
#include <numeric>

#include "sinew/sqm/rings/path_frame.h"
#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

TEST(PathFrame, TurnsNoMoreThanItMust) {
    const Vec3 x = Vec3::UnitZ();  // at right angles to a bend in the plane: it stays
    const Vec3 a = Vec3::UnitX(), b = Vec3(1, 1, 0).normalized();
    EXPECT_TRUE(carry_frame(x, {0, 0, 0}, a, {2, 1, 0}, b).isApprox(x, 1e-12));
    const Vec3 y = Vec3::UnitY();  // along a straight line everything does
    EXPECT_TRUE(carry_frame(y, {0, 0, 0}, a, {5, 0, 0}, a).isApprox(y, 1e-12));

    property::Random random(19);
    for (int i = 0; i < 100; ++i) {
        const Vec3 from = random.direction(), to = random.direction(), ahead = random.direction();
        const Vec3 carried = carry_frame(Vec3(frame_about(from).col(0)), Vec3::Zero(), from, ahead, to);
        EXPECT_NEAR(carried.norm(), 1, 1e-9);
        EXPECT_NEAR(carried.dot(to), 0, 1e-9);
    }
}

TEST(PathFrame, AnglesOnceRoundIncrease) {
    std::vector<double> angles{3, -3, -1.5, 0.2, 1.9};
    unwrap(angles);
    EXPECT_TRUE(std::is_sorted(angles.begin(), angles.end()));
    EXPECT_LT(angles.back() - angles.front(), 2 * M_PI);

    std::vector<double> even(7);
    for (int k = 0; k < 7; ++k) even[k] = 0.3 + 2 * M_PI * k / 7;
    EXPECT_NEAR(even_phase(even), 0.3, 1e-12);
}

TEST(PathFrame, AnglesOfARingThatIsSeenAskewHaveOnePhaseWhereverTheyBegin) {
    const std::vector<double> ring{0.76, 0.74, 0.5, -2.83, -2.82, -2.08, -0.69, -0.3, -0.14, 0.05, 0.27};
    const double step = 2 * M_PI / 11;
    std::vector<double> first = ring;
    unwrap(first);
    for (int begin = 1; begin < 11; ++begin) {
        std::vector<double> angles = ring;
        std::rotate(angles.begin(), angles.begin() + begin, angles.end());
        unwrap(angles);
        const double columns = (even_phase(angles) - even_phase(first)) / step - begin;
        EXPECT_NEAR(columns, 11 * std::round(columns / 11), 1e-9) << begin;
        EXPECT_LT(angles.back() - angles.front(), 4 * M_PI);
    }
}

TEST(PathAngles, StandEvenlyRoundTheTube) {
    const Stages s(star(fan(5)), 8);
    for (std::int32_t p = 0; p < s.network.path_count(); ++p)
        for (std::int32_t k = 1; k < 8; ++k) {
            const double* angle = &s.stations.angle[s.stations.angle_first[p]];
            EXPECT_NEAR(angle[k] - angle[k - 1], 2 * M_PI / 8, 1e-9);
        }
}

constexpr double widest_allowed = 1.6;  // radians, where fewer columns than four would not ask for more

/// The largest angle between neighbouring vertices of a ring, from its centre.
double widest_chord(const Stages& s, std::int32_t path, const Station& ring) {
    const std::int32_t first = s.stations.angle_first[path], sides = s.refinement.path_sides[path];
    const auto angle = [&](std::int32_t k) {
        return s.stations.angle[first + k] + ring.near_share * s.stations.near_uneven[first + k];
    };
    double widest = angle(0) + 2 * M_PI - angle(sides - 1);
    for (std::int32_t k = 1; k < sides; ++k) widest = std::max(widest, angle(k) - angle(k - 1));
    return widest;
}

/// But for what would make one of their chords cave in.
TEST(PathAngles, TurnLittleBetweenAJointAndItsFirstRing) {
    property::Random random(21);
    double most = 0;  // that the joints' rings are uneven
    for (int i = 0; i < 50; ++i) {
        const Stages s(star(random_directions(random, 5), 6));
        for (std::int32_t p = 0; p < s.network.path_count(); ++p) {
            const Station* ring = &s.stations.stations[s.stations.first[p]];
            while (ring->shape == RingShape::follow) ++ring;
            for (std::int32_t k = s.stations.angle_first[p]; k < s.stations.angle_first[p + 1]; ++k) {
                const double uneven = std::abs(s.stations.near_uneven[k]);
                EXPECT_TRUE((1 - ring->near_share) * uneven < 0.2 + 1e-6 ||
                            widest_chord(s, p, *ring) > widest_allowed - 1e-6);
                most = std::max(most, uneven);
            }
        }
    }
    EXPECT_GT(most, 1);
}

TEST(PathAngles, SpreadTheLeastTwistBetweenTwoJoints) {
    property::Random random(20);
    Document d = random_tree(random, 4);
    d.links = {{5, 9}, {11, 17}};
    const Stages s(d);
    for (std::int32_t p = 0; p < s.network.path_count(); ++p) {
        const auto& ends = s.network.path_end[p];
        double before = 0;
        for (std::int32_t i = s.stations.first[p]; i < s.stations.first[p + 1]; ++i) {
            const double turn = s.stations.stations[i].turn;
            EXPECT_LE(std::abs(turn), M_PI / s.refinement.path_sides[p] + 1e-9);
            EXPECT_GE(turn * before, 0);
            EXPECT_GE(std::abs(turn), std::abs(before) - 1e-12);
            EXPECT_TRUE(turn == 0 || (ends[0].at_joint() && ends[1].at_joint()));
            before = turn;
        }
    }
}

TEST(PathAngles, OfAClosedPathMeetThemselves) {
    std::vector<Vec3> places = fan(12);
    for (std::size_t i = 0; i < places.size(); ++i)
        places[i] = 6 * places[i] + 1.5 * std::sin(double(i)) * Vec3::UnitZ();
    Document d = chain(places, 0.3);
    d.links = {{0, 11}};
    const Stages s(d);
    EXPECT_EQ(s.ring_count(0), 12);
    for (const Station& ring : s.stations.stations) EXPECT_LE(std::abs(ring.turn), M_PI / 4 + 1e-9);
}

TEST(PathAngles, OfAClosedCoilGoOnInTheColumnsThatTheyEndIn) {
    int turned = 0;
    for (int waves = 1; waves <= 5; ++waves) {
        const Stages s(closed_coil(60, waves, 0.3), 12);
        const std::vector<Station> rings = s.rings(0);
        const Station &first = rings.front(), &last = rings.back();
        const Vec3 carried = carry_frame(last.x, last.centre, last.tangent, first.centre, first.tangent);
        const double frame = angle_round(carried, first.x, first.tangent.cross(first.x));
        for (int k = 0; k < 12; ++k) {
            const double ends = s.stations.angle[k] + last.turn + frame,
                         begins = s.stations.angle[(k + s.stations.far_shift[0]) % 12] + first.turn;
            // What twist there is, at most half a column's, is spread over all rings.
            EXPECT_LT(std::abs(std::remainder(ends - begins, 2 * M_PI)), M_PI / 12 * 2 / 60) << waves;
        }
        turned += s.stations.far_shift[0] % 6 != 0;
    }
    EXPECT_GT(turned, 2);
}

/// A bar whose arms at one end stand exactly half a column off those at the other, turned about an axis.
TEST(PathAngles, OfImagesUnderARotationTakeTheSameOneOfTwoTurnsAsNear) {
    for (const int count : {3, 5, 7}) {
        Document d;
        add(d, -1, {0, 0, 0}, 0.3);
        const std::int32_t low = add(d, 0, {4, 0, 0}, 0.2), high = add(d, low, {9, 0, 0}, 0.2);
        const double half = std::sqrt(0.5);
        for (const Vec3& arm : {Vec3(0, 1, 0), Vec3(0, -1, 0)}) add(d, low, d.nodes[low].position + arm, 0.2);
        for (const Vec3& arm : {Vec3(0, half, half), Vec3(0, -half, -half)})
            add(d, high, d.nodes[high].position + arm, 0.2);
        d.symmetry = {Symmetry::Kind::radial, 2, count};
        const Stages s(expanded(d));
        ASSERT_EQ(s.images.order, count);
        int ties = 0;
        for (std::int32_t p = 0; p < s.network.path_count(); ++p) {
            const std::vector<Station> rings = s.rings(p), images = s.rings(s.images.path[p]);
            ASSERT_EQ(rings.size(), images.size());
            for (std::size_t i = 0; i < rings.size(); ++i)
                EXPECT_NEAR(rings[i].turn, images[i].turn, 1e-9) << count;
            const double twist = rings.empty() ? 0 : std::abs(rings.back().turn);
            ties += twist > 0.6 * M_PI / s.refinement.path_sides[p];
        }
        EXPECT_GE(ties, count);
    }
}

TEST(PathAngles, PutTheCornersOfOutlinesOnCornerColumns) {
    Document d;
    for (int i = 0; i < 4; ++i) {
        d.nodes[add(d, i - 1, {4.0 * i, 0.3 * i * i, 0}, 0.4)].section = Section::rectangular;
        d.nodes.back().roll = 10;
    }
    const Stages s(d, 12);
    ASSERT_GE(s.stations.corner[0], 0);
    for (const Station& ring : s.stations.stations) {
        if (ring.shape != RingShape::outline) continue;
        const double corner = angle_round(ring.form_x, ring.x, ring.tangent.cross(ring.x)) + M_PI / 4;
        const double column = s.stations.angle[s.stations.corner[0]] + ring.turn;
        const double quarters = (column - corner) / (M_PI / 2);
        EXPECT_NEAR(quarters, std::round(quarters), 1e-6);
    }
}

}  // namespace
}  // namespace sinew::sqm
