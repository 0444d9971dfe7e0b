#include "sinew/sqm/counts/path_needs.h"

#include "sinew/sqm/counts/joint_problem.h"
#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

struct Asked {
    Plain skeleton;
    Network network;
    Polyhedra polyhedra;
    JointSurfaces surfaces;
    Images images;
    PathNeeds needs;

    explicit Asked(Plain plain, std::int32_t sides = 4)
        : skeleton(std::move(plain)),
          network(find_network(skeleton)),
          polyhedra(make_polyhedra(skeleton, network).value()),
          surfaces(find_surfaces(skeleton, network)),
          images(find_images(skeleton, network, polyhedra)),
          needs(find_path_needs(skeleton, network, polyhedra, surfaces, images, sides)) {}
};

TEST(PathNeeds, AreTheSidesOfCellsAndFourAtLeast) {
    property::Random random(22);
    for (int degree = 4; degree < 20; ++degree) {
        const Asked asked(plain_of(star(random_directions(random, degree))));
        for (std::int32_t p = 0; p < degree; ++p) {
            EXPECT_EQ(asked.needs.least[p],
                      std::max<std::int32_t>(4, sum_of_cell(asked.polyhedra, p, asked.needs.pieces)));
            EXPECT_EQ(asked.needs.step[p], 1);
        }
        // Six or more bones that lie in general position part each pair of cells by one arc.
        if (degree >= 6) {
            for (std::size_t a = 0; a < asked.needs.pieces.size();
                 ++a) {  // but by a chord where the joint would cave in
                const double length = arc_length(asked.polyhedra, asked.polyhedra.arcs[a]);
                EXPECT_EQ(asked.needs.pieces[a], std::ceil(length / longest_at_blend));
            }
        }
    }
}

TEST(PathNeeds, AreWhatIsAskedForWhereCellsAllowIt) {
    property::Random random(24);
    const Asked asked(plain_of(star(random_directions(random, 5))), 9);
    EXPECT_EQ(asked.needs.least, std::vector<std::int32_t>(5, 9));
}

TEST(PathNeeds, OfRectanglesAreFoursAndOfThoseAcrossAMirrorEights) {
    Document d = star(fan(5));
    d.nodes[1].section = Section::rectangular;
    const Asked plain(plain_of(d), 5);
    EXPECT_EQ(plain.needs.corners, (std::vector<std::uint8_t>{1, 0, 0, 0, 0}));
    EXPECT_EQ(plain.needs.step[0] % 4, 0);
    EXPECT_EQ(plain.needs.least[0], 8);

    d = star(std::vector<Vec3>{{0, 1, 0}, {-0.8, -0.6, 0}, {0.8, -0.6, 0}});
    d.nodes[1].section = Section::rectangular;
    const Asked mirrored(plain_of(d));
    ASSERT_TRUE(mirrored.images.any());
    EXPECT_EQ(mirrored.needs.step, (std::vector<std::int32_t>{8, 1, 1}));
}

TEST(PathNeeds, OnTheAxisAreMultiplesOfTheOrderOfTheSymmetry) {
    for (const int count : {3, 5, 7}) {
        const Asked asked(expanded(wheel(count)));
        ASSERT_EQ(asked.images.order, count);
        for (std::int32_t p = 0; p < asked.network.path_count(); ++p) {
            const bool on_axis = asked.images.path[p] == p;
            EXPECT_EQ(asked.needs.step[p], on_axis ? count : 1);
            EXPECT_EQ(asked.needs.least[p] % asked.needs.step[p], 0);
        }
    }
}

}  // namespace
}  // namespace sinew::sqm
