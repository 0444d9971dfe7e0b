#include "sinew/sqm/surface/cell_room.h"

#include "sinew/mesh/intersect.h"
#include "sinew/sqm/skin.h"
#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

/// Three bones of length 3 in a plane, evenly round z.
struct Star {
    Stages stages{star(fan(3))};
    CellRoom room{stages.skeleton, stages.network, stages.polyhedra, stages.surfaces, 0, 0};
};

double angle_to_x(const Vec3& v) { return std::atan2(v.tail<2>().norm(), v.x()); }

TEST(CellRoom, LeavesWhatIsInside) {
    const Star star;
    for (const Vec3& place : {Vec3(1, 0, 0), Vec3(1, 0.5, 3), Vec3(1, -1.2, -0.5), Vec3(0.1, 0, -2)})
        EXPECT_EQ(star.room.pull_in(place), place);
}

TEST(CellRoom, PullsWhatIsOutsideAcrossTheBone) {
    const Star star;
    for (const Vec3& place : {Vec3(1, 2, 0), Vec3(1, -2, 0.5)}) {
        const Vec3 pulled = star.room.pull_in(place);
        EXPECT_NEAR(pulled.x(), place.x(), 1e-12);
        EXPECT_LT(std::abs(pulled.y()), std::sqrt(3.0) * pulled.x());  // 60 degrees on both sides
        EXPECT_GT(std::abs(pulled.y()), 0.9 * std::sqrt(3.0) * pulled.x());
        EXPECT_NEAR((star.room.pull_in(pulled) - pulled).norm(), 0, 1e-12);
    }
    const Vec3 behind = star.room.pull_in({-1, 0.2, 0});
    EXPECT_LT(angle_to_x(behind), M_PI / 3);
}

TEST(CellRoom, EndsWithTheNeighbours) {
    const Star star;
    const Vec3 beyond(2, 4, 0);
    EXPECT_EQ(star.room.pull_in(beyond), beyond);
}

/// Bones that leave in nearly one direction have cells that are drawn apart, beside the bones.
TEST(CellRoom, PullsIntoTheCellEvenIfTheBoneIsBesideIt) {
    const Stages s(star(std::vector<Vec3>{Vec3(1, 0.0005, 0), Vec3(1, 0, 0), Vec3(1, -0.0005, 0),
                                          Vec3(1, 0, 0.0005), Vec3(-1, 0, 0), Vec3(0, 0, 1)},
                        3, 0.3));
    property::Random random(36);
    for (std::int32_t slot = 0; slot < 4; ++slot) {
        const CellRoom room(s.skeleton, s.network, s.polyhedra, s.surfaces, 0, slot);
        for (int i = 0; i < 50; ++i) {
            const Vec3 pulled = room.pull_in(random.between(0.5, 2) * random.direction());
            std::int32_t nearest = 0;
            for (std::int32_t c = 1; c < s.polyhedra.cell_count(); ++c)
                if (s.polyhedra.sites[c].dot(pulled) > s.polyhedra.sites[nearest].dot(pulled)) nearest = c;
            EXPECT_EQ(nearest, slot);
        }
    }
}

TEST(CellRoom, LetsOneGoAsFarAsTheWall) {
    const Star star;
    const Vec3 to_wall = Vec3(-std::sqrt(3.0), 1, 0) / 2;  // at right angles to the wall at 60 degrees
    const double whole = std::sqrt(3.0);                   // from (2, 0, 0)
    EXPECT_LT(star.room.free_distance({2, 0, 0}, to_wall, 5), whole);
    EXPECT_GT(star.room.free_distance({2, 0, 0}, to_wall, 5), 0.95 * whole);
    EXPECT_EQ(star.room.free_distance({2, 0, 0}, to_wall, 1), 1);
    EXPECT_EQ(star.room.free_distance({2, 0, 0}, Vec3::UnitX(), 5), 5);
    EXPECT_EQ(star.room.free_distance({2, 0, 0}, Vec3::UnitZ(), 5), 5);
}

/// Tubes that are too wide for their cells, one beside the other.
TEST(CellRoom, KeepsTubesOfNarrowForksApart) {
    const std::vector<std::vector<Ball>> forks{
        // two thin bones beside each other, from a ball that hardly lets them out
        {{-1, {0, 0, 0}, 2},
         {0, {-2.5, 1.5, -1.75}, 0.5},
         {0, {1.25, -1.5, 1.25}, 0.5},
         {0, {1.25, -2, 1.25}, 0.25},
         {0, {0.25, -2.75, -3}, 0.5}},
        // a bone that turns away at once, beside a wide one
        {{-1, {0, 0, -3}, 1},
         {0, {0, 0, 0}, 1},
         {1, {1, 0, 1.5}, 0.4},
         {2, {0, 2, 2}, 0.4},
         {1, {-1, 0, 4}, 1}},
        // joints nearer to each other than their balls' neighbours
        {{-1, {0, 0, 0}, 0.5},
         {0, {-0.25, 2.75, 1.25}, 1},
         {0, {0, 0, 0.5}, 1},
         {0, {0, -1.5, -2}, 0.25},
         {0, {-1.75, 3, -1}, 1},
         {1, {0.75, 4.25, -0.25}, 1},
         {1, {-1, 1.5, 1.75}, 1}}};
    for (const std::vector<Ball>& fork : forks) {
        const Document d = tree(fork);
        for (const bool repair : {false, true}) {
            const auto skin = sinew::skin(d, {.repair = repair});
            ASSERT_TRUE(skin);
            EXPECT_TRUE(find_self_intersections(skin->mesh)->empty());
        }
    }
}

}  // namespace
}  // namespace sinew::sqm
