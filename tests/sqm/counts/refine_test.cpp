#include "sinew/sqm/counts/refine.h"

#include <algorithm>

#include "sinew/sqm/counts/joint_problem.h"
#include "sinew/sqm/counts/regions.h"
#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

/// Both ends of every path have the path's number of vertices; arcs that would be one edge twice are parted.
void expect_agreement(const Stages& s) {
    for (std::int32_t p = 0; p < s.network.path_count(); ++p) {
        EXPECT_GE(s.refinement.path_sides[p], 4);
        for (const PathEnd& end : s.network.path_end[p]) {
            if (!end.at_joint()) continue;
            EXPECT_EQ(s.round_cell(s.polyhedra.cell_first[end.joint] + end.slot), s.refinement.path_sides[p]);
        }
    }
    for (const std::int32_t pieces : s.refinement.pieces) EXPECT_GE(pieces, 1);
    for (std::int32_t c = 0; c < s.polyhedra.cell_count(); ++c) {
        if (s.polyhedra.cell(c).size() != 2) continue;
        for (const CellSide& side : s.polyhedra.cell(c)) EXPECT_GE(s.refinement.pieces[side.arc], 2);
    }
}

/// All paths of the core of a component have the same number of vertices round them, and an even one.
void expect_one_even_count(const Stages& s) {
    expect_agreement(s);
    const Regions regions = find_regions(s.network);
    std::vector<std::int32_t> count(regions.components, 0);
    for (std::int32_t p = 0; p < s.network.path_count(); ++p) {
        if (!regions.core[p]) continue;
        std::int32_t& shared = count[regions.component_of(s.network, p)];
        if (shared == 0) shared = s.refinement.path_sides[p];
        EXPECT_EQ(s.refinement.path_sides[p], shared);
        EXPECT_EQ(shared % 2, 0);
    }
    EXPECT_GT(*std::max_element(count.begin(), count.end()), 0) << "a core";
}

TEST(Refine, ThreeBonesShareTheirArcsInTwos) {
    const Stages s(star(fan(3)));
    expect_agreement(s);
    EXPECT_EQ(s.refinement.pieces, (std::vector<std::int32_t>{2, 2, 2}));
    EXPECT_EQ(s.refinement.path_sides, (std::vector<std::int32_t>{4, 4, 4}));
}

TEST(Refine, WithoutAJointARingHasFour) {
    const std::vector<Vec3> places{{0, 0, 0}, {3, 0, 0}};
    EXPECT_EQ(Stages(chain(places, 0.5)).refinement.path_sides, std::vector<std::int32_t>{4});
    EXPECT_EQ(Stages(chain(places, 0.5), 9).refinement.path_sides, std::vector<std::int32_t>{9});
}

TEST(Refine, OfTreesAgreesAtBothEndsOfEveryPath) {
    property::Random random(9);
    for (int round = 0; round < 30; ++round) expect_agreement(Stages(random_tree(random, 1 + round % 4)));
}

TEST(Refine, OfAStarHasNoMoreThanItsCellsNeed) {
    property::Random random(10);
    for (int degree = 4; degree < 12; ++degree) {
        const Stages s(star(random_directions(random, degree)));
        expect_agreement(s);
        for (std::int32_t p = 0; p < degree;
             ++p) {  // the pieces of its cell's sides, or four; at most some beside it
            std::int32_t least = 0;
            for (const CellSide& side : s.polyhedra.cell(p))
                least += least_pieces(s.skeleton, s.network, s.polyhedra, s.surfaces, 0, side.arc);
            EXPECT_LE(s.refinement.path_sides[p], std::max(4, least) + 2);
        }
    }
}

TEST(Refine, OnCyclesAllPathsShareOneEvenCount) {
    const Stages s(cube_of_struts());
    expect_agreement(s);
    EXPECT_EQ(s.refinement.path_sides, std::vector<std::int32_t>(12, 4));

    property::Random random(11);
    Document d = random_tree(random, 3);
    d.links = {{7, 12}, {8, 15}, {9, 20}};
    expect_one_even_count(Stages(d));
    // Loops at a joint whose cells have five sides: five would do for the loop too.
    int of_five_sides = 0;
    for (int round = 0; round < 20; ++round) {
        Document loop = star(random_directions(random, 8));
        loop.links = {{1, 2}};
        const Stages s(loop);
        expect_one_even_count(s);
        std::size_t most = 0;
        for (std::int32_t c = 0; c < 2; ++c) most = std::max(most, s.polyhedra.cell(c).size());
        of_five_sides += most == 5;
    }
    EXPECT_GT(of_five_sides, 3);
}

TEST(Refine, GivesEveryPathTheSidesThatAreAskedForOrTheNextThatFit) {
    property::Random random(12);
    for (const int sides : {4, 6, 8, 12, 16}) {
        const Stages lattice(cube_of_struts(), sides);
        expect_agreement(lattice);
        EXPECT_EQ(lattice.refinement.path_sides, std::vector<std::int32_t>(12, sides));
    }
    for (const int sides : {5, 7, 11}) {
        const Stages tree(random_tree(random, 3), sides);
        expect_agreement(tree);
        const auto [low, high] =
            std::minmax_element(tree.refinement.path_sides.begin(), tree.refinement.path_sides.end());
        EXPECT_GE(*low, sides);
        EXPECT_EQ(*low, *high);
    }
}

TEST(Refine, SplitsImagesAlike) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.4);
    add(d, 0, {0, 3, 1}, 0.4);
    for (const double side : {-1.0, 1.0}) {
        const std::int32_t hip = add(d, 0, {side * 3, 0, 0}, 0.3);
        for (int toe = -1; toe <= 2; ++toe) add(d, hip, {side * 5, 0.8 * toe, 1.0 * toe * toe}, 0.2);
    }
    const Stages s(d);
    expect_agreement(s);
    ASSERT_TRUE(s.images.any());
    for (std::size_t a = 0; a < s.refinement.pieces.size(); ++a)
        EXPECT_EQ(s.refinement.pieces[a], s.refinement.pieces[s.images.arc[a]]);
    for (std::size_t p = 0; p < s.refinement.path_sides.size(); ++p)
        EXPECT_EQ(s.refinement.path_sides[p], s.refinement.path_sides[s.images.path[p]]);
}

TEST(Refine, RectanglesHaveFourEvenSides) {
    Document d = star(fan(5));
    d.nodes[1].section = Section::rectangular;
    const Stages s(d);
    expect_agreement(s);
    EXPECT_EQ(s.refinement.path_sides[0] % 4, 0);
}

TEST(Refine, RectanglesHaveFourEvenSidesWhateverElseLeavesTheirJoint) {
    property::Random random(34);
    for (int round = 0; round < 60; ++round) {
        Document d = star(random_directions(random, 4 + round % 5));
        for (const int arm : {1, 2}) d.nodes[arm].section = Section::rectangular;
        const Stages s(d);
        expect_agreement(s);
        for (const int path : {0, 1}) EXPECT_EQ(s.refinement.path_sides[path] % 4, 0) << round;
    }
}

TEST(Refine, RectanglesInAMirrorHaveAVertexInTheMiddleOfTheirSides) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.4);
    d.nodes[add(d, 0, {0, 3, 0}, 0.4)].section = Section::rectangular;
    for (const double side : {-2.0, 2.0}) add(d, 0, {side, -1, 0}, 0.3);
    const Stages s(d);
    expect_agreement(s);
    ASSERT_TRUE(s.images.any());
    EXPECT_EQ(s.refinement.path_sides, (std::vector<std::int32_t>{8, 6, 6}));  // 4 + 4, 4 + 2, 4 + 2
}

TEST(Refine, StopsOnRequest) {
    const std::atomic<bool> stop{true};
    const Plain skeleton = plain_of(cube_of_struts());
    const Network n = find_network(skeleton);
    const auto r = refine(skeleton, n, make_polyhedra(skeleton, n).value(), find_surfaces(skeleton, n), {},
                          {}, Progress({}, &stop));
    ASSERT_FALSE(r);
    EXPECT_EQ(r.error().kind, ErrorKind::cancelled);
}

}  // namespace
}  // namespace sinew::sqm
