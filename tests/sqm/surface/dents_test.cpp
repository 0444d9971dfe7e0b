#include "sinew/sqm/surface/dents.h"

#include "sinew/sqm/surface/joint_reach.h"
#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

constexpr double width = 0.3;  // half of that of the dents

/// A ball of radius 1 with two dents at this angle to each other, about the z axis in the plane y = 0.
struct Dented {
    Stages s;
    /// As deep as half their width, so that they are balls: their half extent is the same in all directions.
    explicit Dented(double angle, double depth = width)
        : s(dented_ball(std::vector<double>{-angle / 2, angle / 2}, width, depth)) {}

    const PitShape& pit(int i) const { return s.surfaces.pits[i]; }
    double floor(const Vec3& ray) const { return exit_of_joint(s.network, s.surfaces, 0, Vec3::Zero(), ray); }
    std::int32_t slot_of(int i) const {
        const auto& kind = s.surfaces.kind;
        auto at = std::find(kind.begin(), kind.end(), SlotKind::pit);
        for (; i > 0; --i) at = std::find(at + 1, kind.end(), SlotKind::pit);
        return static_cast<std::int32_t>(at - kind.begin());
    }
};
Vec3 tilted(double angle) { return {std::sin(angle), 0, std::cos(angle)}; }
/// The angle at which the rims of two dents touch: at their middles a chord of twice `width` apart.
const double touch = 2 * std::asin(width);

TEST(Dents, AreEllipsoidsAboutTheSurfaceAsDrawn) {
    const double depth = 0.2;
    const Dented d(2, depth);
    ASSERT_EQ(d.s.surfaces.pits.size(), 2u);
    for (const int i : {0, 1}) {
        const PitShape& pit = d.pit(i);
        EXPECT_NEAR(pit.middle.norm(), 1, 1e-9);
        EXPECT_NEAR(std::abs(pit.z.dot(tilted(1))) + std::abs(pit.z.dot(tilted(-1))),
                    1 + std::abs(std::cos(2)), 1e-9);
        EXPECT_TRUE(pit.half.isApprox(Vec3(width, width, depth), 1e-9));
        EXPECT_NEAR(pit.x.cross(pit.y).dot(pit.z), 1, 1e-9);
        EXPECT_NEAR(d.floor(pit.z), 1 - depth, 1e-9);
    }
    EXPECT_TRUE(has_dents(d.s.surfaces, 0));
    EXPECT_FALSE(has_groove(d.s.surfaces, 0));
}

TEST(Dents, OverlapWhereTheirOpeningsDo) {
    for (const double angle : {0.9 * touch, 0.999 * touch, 1.001 * touch, 1.5 * touch}) {
        const Dented d(angle);
        const bool overlap = angle < touch;
        EXPECT_EQ(dents_overlap(d.s.surfaces, d.slot_of(0), d.slot_of(1)), overlap);
        for (const int i : {0, 1}) EXPECT_EQ(merges(d.s.surfaces, 0, d.slot_of(i)), overlap);
        EXPECT_EQ(has_groove(d.s.surfaces, 0), overlap);
    }
}

TEST(Dents, OfOtherSlotsNeverOverlap) {
    const Dented d(0.9 * touch);
    for (std::int32_t slot = 0; slot < d.s.network.degree(0); ++slot)
        if (d.s.surfaces.kind[slot] != SlotKind::pit)
            EXPECT_FALSE(dents_overlap(d.s.surfaces, slot, d.slot_of(0)));
}

/// A groove grows out of nothing: its narrowest place, in the middle, is as wide as the overlap is of a fifth
/// of a dent's half width, and whole from there on.
TEST(Dents, MakeAGrooveThatComesAndGoesSmoothly) {
    double before = 0;
    for (double share = 0.02; share < 1.6; share += 0.02) {
        const double distance = 2 * width - 0.2 * width * share;
        const Dented d(2 * std::asin(distance / 2));
        const auto& pits = d.s.surfaces.pits;
        const PitShape* middle = &pits[2];
        for (std::size_t i = 2; i < pits.size(); ++i)
            if (pits[i].z.z() > middle->z.z()) middle = &pits[i];
        // An even number of steps has a dent just in the middle.
        if (middle->z.z() > 1 - 1e-9)
            EXPECT_TRUE(middle->half.isApprox(std::min(1.0, share) * Vec3(width, width, width), 1e-6));
        for (std::size_t i = 2; i < pits.size(); ++i) {
            EXPECT_LE(pits[i].half.x(), width + 1e-9);
            EXPECT_GE(pits[i].half.x(), std::min(1.0, share) * width - 1e-9);
            EXPECT_NEAR(pits[i].middle.norm(), 1, 1e-9);
        }
        const double floor = 1 - d.floor(Vec3::UnitZ());
        EXPECT_LE(floor, width + 1e-9);
        EXPECT_LT(floor - before, 0.35 * width) << "it does not jump";
        EXPECT_GE(floor, before - 0.002 * width) << "but for the scallops";
        before = floor;
    }
    EXPECT_NEAR(before, width, 1e-2 * width);
}

TEST(Dents, EndAtTheirRim) {
    const Dented d(2);
    const PitShape& pit = d.pit(0);
    for (double angle = 0; angle < 6; angle += 0.5) {
        const Vec3 side = std::cos(angle) * pit.x + std::sin(angle) * pit.y;
        const Vec3 rim =
            rim_towards(d.s.network, d.s.surfaces, 0, pit, Vec3::Zero(), (pit.z + 0.1 * side).normalized());
        EXPECT_NEAR(pit.local(rim - pit.middle).norm(), 1, 1e-4);  // on the ball and on the ellipsoid
        EXPECT_TRUE(on_rim(d.s.network, d.s.surfaces, 0, Vec3::Zero(), rim));
        const Vec3 inside = (0.9 * rim + 0.1 * pit.z).normalized(),
                   outside = (1.1 * rim - 0.1 * pit.z).normalized();
        EXPECT_TRUE(leads_into_dent(d.s.network, d.s.surfaces, 0, Vec3::Zero(), inside));
        EXPECT_FALSE(leads_into_dent(d.s.network, d.s.surfaces, 0, Vec3::Zero(), outside));
        EXPECT_TRUE(in_dent(d.s.network, d.s.surfaces, 0, Vec3::Zero(), d.floor(inside) * inside));
        EXPECT_FALSE(in_dent(d.s.network, d.s.surfaces, 0, Vec3::Zero(), outside));
        EXPECT_FALSE(on_rim(d.s.network, d.s.surfaces, 0, Vec3::Zero(), d.floor(inside) * inside));
        EXPECT_FALSE(on_rim(d.s.network, d.s.surfaces, 0, Vec3::Zero(), outside));
    }
}

TEST(Dents, OfAGrooveHaveOneRimRoundBoth) {
    const Dented d(0.8 * touch);
    const Vec3 towards = d.pit(0).z.x() < 0 ? Vec3::UnitX() : Vec3(-Vec3::UnitX());
    const Vec3 across = rim_towards(d.s.network, d.s.surfaces, 0, d.pit(0), Vec3::Zero(),
                                    (d.pit(0).z + 0.1 * towards).normalized());
    // Through the groove, and out at the far side of the other dent.
    EXPECT_NEAR(d.pit(1).local(across - d.pit(1).middle).norm(), 1, 1e-4);
    EXPECT_GT(across.dot(towards), d.pit(1).z.dot(towards));
}

TEST(Dents, WallsLookOutOfTheSolid) {
    const Dented d(2);
    const PitShape& pit = d.pit(0);
    const DentWall bottom = nearest_wall(d.s.surfaces, 0, (1 - width) * pit.z);
    EXPECT_TRUE(bottom.touches);
    EXPECT_TRUE(bottom.normal.isApprox(pit.z, 1e-9));
    const DentWall rim = nearest_wall(d.s.surfaces, 0, pit.middle + width * pit.x);
    EXPECT_TRUE(rim.touches);
    EXPECT_TRUE(rim.normal.isApprox(-pit.x, 1e-9));
    EXPECT_FALSE(nearest_wall(d.s.surfaces, 0, -pit.middle).touches);
}

TEST(Dents, NeverReachTheCentreOfTheirJoint) {
    Stages s(dented_ball(std::vector<double>{0}, 0.5, 0.5));
    s.surfaces.pits[0].half.z() = 1.2;  // as deep as if it went through the centre
    const double floor = press_dents(s.surfaces, 0, Vec3::Zero(), Vec3::UnitZ(), 1);
    EXPECT_GT(floor, 0);
    EXPECT_LT(floor, 0.1);
    EXPECT_EQ(press_dents(s.surfaces, 0, Vec3::Zero(), -Vec3::UnitZ(), 1), 1);
}

}  // namespace
}  // namespace sinew::sqm
