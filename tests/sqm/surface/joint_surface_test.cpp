#include "sinew/sqm/surface/joint_surface.h"

#include "sinew/mesh/intersect.h"
#include "sinew/sqm/skin.h"
#include "sinew/sqm/surface/joint_reach.h"
#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

BeamFrom beam(const Vec2& near, const Vec2& far, Section section) {
    return {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(), 10, near, far, section};
}

TEST(BeamFrom, OfARectangleIsABoxWithItsCap) {
    const BeamFrom b = beam({2, 1}, {2, 1}, Section::rectangular);
    EXPECT_NEAR(b.exit(Vec3::UnitX()), 2, 1e-12);
    EXPECT_NEAR(b.exit(-Vec3::UnitY()), 1, 1e-12);
    EXPECT_NEAR(b.exit(Vec3(2, 1, 0).normalized()), std::sqrt(5.0), 1e-12);
    EXPECT_NEAR(b.exit(Vec3(1, 0, 1).normalized()), 2 * std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(b.exit(Vec3::UnitZ()), 10, 1e-12);
    EXPECT_NEAR(b.exit(-Vec3::UnitZ()), 1, 1e-12);  // as deep as the outline is narrow
}

TEST(BeamFrom, OfAnEllipseLiesOnIt) {
    const BeamFrom b = beam({2, 1}, {1, 3}, Section::round);
    property::Random random(13);
    for (int i = 0; i < 200; ++i) {
        const Vec3 ray = random.direction(), at = b.exit(ray) * ray;
        const double h = std::clamp(at.z() / 10, 0.0, 1.0);
        const Vec2 half = (1 - h) * b.near + h * b.far;
        if (at.z() > 10 - 1e-6) continue;  // through its end
        const double cap = at.z() < 0 ? at.z() : 0;
        EXPECT_NEAR(Vec3(at.x() / half.x(), at.y() / half.y(), cap).norm(), 1, 1e-6);
    }
}

TEST(PitShape, TakesAwayWhatIsInsideItAndNothingElse) {
    const PitShape pit{{0, 0, 2}, Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(), {0.5, 0.25, 0.75}};
    EXPECT_NEAR(pit.press(Vec3::Zero(), Vec3::UnitZ(), 2), 1.25, 1e-12);  // as deep as it is
    EXPECT_EQ(pit.press(Vec3::Zero(), Vec3::UnitX(), 2), 2);
    EXPECT_EQ(pit.press(Vec3::Zero(), Vec3::UnitZ(), 1), 1);  // already below its floor
    const Vec3 slant = Vec3(0.3, 0, 2).normalized();
    const Vec3 floor = pit.press(Vec3::Zero(), slant, 2) * slant - pit.middle;
    EXPECT_NEAR(floor.cwiseQuotient(pit.half).norm(), 1, 1e-9);
}

TEST(JointSurface, ReachesAtMostAsFarAsTheNextJointDoesNot) {
    const Stages s(cube_of_struts(4, 0.3));
    for (std::int32_t p = 0; p < s.network.path_count(); ++p) {
        double reach = 0;
        for (const PathEnd& end : s.network.path_end[p])
            reach += s.surfaces.limit[s.network.slot_first[end.joint] + end.slot];
        EXPECT_LT(reach, 4);
        EXPECT_GT(reach, 3);
    }
    for (const SlotKind kind : s.surfaces.kind) EXPECT_EQ(kind, SlotKind::cone);
}

/// Narrow forks whose tubes part beyond the next node, and then turn away.
TEST(JointSurface, EndsAtTheNextNode) {
    const std::vector<std::vector<Ball>> forks{// the fork hides the bend
                                               {{-1, {-3.28, 0.77, -1.22}, 0.94},
                                                {0, {0, 0, 0}, 1},
                                                {1, {2.25, 0, 0.97}, 0.8},
                                                {2, {3.5, 0.09, 0.46}, 0.56},
                                                {3, {5.15, 0.64, 0}, 0.75},
                                                {3, {2.25, 0, -0.64}, 0.48}},
                                               // a twig that is inside the tube beside it at first
                                               {{-1, {0.69, -0.2, -2.2}, 1},
                                                {0, {0, 0, 0}, 1},
                                                {1, {-0.56, 0.3, 1.19}, 1},
                                                {2, {-0.85, 0.97, 2.44}, 1},
                                                {1, {0.45, 0.47, 1.24}, 0.07},
                                                {4, {1.7, 0.84, 3.3}, 0.06}},
                                               // one leaf inside another
                                               {{-1, {0, 0, 0}, 2.3},
                                                {0, {1, 0, -2}, 4},
                                                {0, {0, 0, 4}, 0.5},
                                                {0, {0, 0, 5}, 3.5},
                                                {0, {1, 1, -3}, 3.5}}};
    for (const std::vector<Ball>& balls : forks) {
        const Document d = tree(balls);
        const auto skin = sinew::skin(d);
        ASSERT_TRUE(skin);
        EXPECT_TRUE(find_self_intersections(skin->mesh)->empty());
    }
}

TEST(JointSurface, KnowsBeamsPitsAndBareSurface) {
    Document d;
    add(d, -1, {0, 0, 0}, 1);
    d.nodes[0].type = NodeType::ball;
    d.nodes[add(d, 0, {3, 0, 0}, 0.3)].section = Section::rectangular;
    d.nodes[add(d, 0, {0, 1.2, 0}, 0.3)].type = NodeType::negative;
    const Stages s(d);
    const auto count = [&](SlotKind kind) {
        return std::count(s.surfaces.kind.begin(), s.surfaces.kind.end(), kind);
    };
    EXPECT_EQ(count(SlotKind::pit), 1);
    EXPECT_GE(count(SlotKind::surface), 1);
    ASSERT_EQ(s.surfaces.pits.size(), 1u);
    EXPECT_NEAR(s.surfaces.pits[0].middle.y(), 1, 1e-9);
    EXPECT_NEAR(s.surfaces.pits[0].half.z(), 0.2, 1e-9);
    const double floor = exit_of_joint(s.network, s.surfaces, 0, Vec3::Zero(), Vec3::UnitY());
    EXPECT_NEAR(floor, 0.8, 1e-9);
    EXPECT_NEAR(exit_of_joint(s.network, s.surfaces, 0, Vec3::Zero(), -Vec3::UnitY()), 1, 1e-9);
}

}  // namespace
}  // namespace sinew::sqm
