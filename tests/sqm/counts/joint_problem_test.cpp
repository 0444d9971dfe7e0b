#include "sinew/sqm/counts/joint_problem.h"

#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

struct Joint {
    Plain skeleton;
    Network network;
    Polyhedra polyhedra;
    JointSurfaces surfaces;
    Images images;
    JointProblem problem{skeleton, network, polyhedra, surfaces, images};

    explicit Joint(const Document& document)
        : skeleton(plain_of(document)),
          network(find_network(skeleton)),
          polyhedra(make_polyhedra(skeleton, network).value()),
          surfaces(find_surfaces(skeleton, network)),
          images(find_images(skeleton, network, polyhedra)) {
        problem.take(0);
        problem.ask_nothing_yet();
    }
    Joint(const Joint&) = delete;
    std::int32_t count(std::int32_t cell) const {
        std::int32_t sum = 0;
        for (const CellSide& side : polyhedra.cell(cell)) sum += problem.pieces(side.arc);
        return sum;
    }
};

TEST(JointProblem, GivesOneCellWhatItAsksAndTheOthersAtLeastTheirLeast) {
    property::Random random(23);
    for (int degree = 4; degree < 12; ++degree) {
        Joint joint(star(random_directions(random, degree)));
        const std::int32_t asked = joint.problem.least(0) + 3;
        joint.problem.ask(0, asked, true, false);
        for (std::int32_t c = 1; c < degree; ++c) joint.problem.ask(c, joint.problem.least(c), false, c % 2);
        ASSERT_TRUE(joint.problem.solve());
        EXPECT_EQ(joint.count(0), asked);
        for (std::int32_t c = 1; c < degree; ++c) EXPECT_GE(joint.count(c), joint.problem.least(c));
    }
}

TEST(JointProblem, PartsArcsWithBothEndsInCommon) {
    const Joint joint(star(fan(3)));
    for (std::int32_t a = 0; a < 3; ++a)
        EXPECT_EQ(least_pieces(joint.skeleton, joint.network, joint.polyhedra, joint.surfaces, 0, a), 2);
    EXPECT_EQ(joint.problem.least(0), 4);
}

TEST(JointProblem, SplitsImagesAlikeAndRefusesOddCountsInTheMirror) {
    // One bone lies in the mirror x = 0; the two others change places.
    Joint joint(star(std::vector<Vec3>{{0, 1, 0}, {-0.8, -0.6, 0.1}, {0.8, -0.6, 0.1}, {0, 0, -1}}));
    ASSERT_TRUE(joint.images.any());
    EXPECT_EQ(joint.problem.step(0), 2);
    EXPECT_EQ(joint.problem.step(1), 1);

    joint.problem.ask(0, 10, true, false);
    joint.problem.ask(1, 7, false, false);
    ASSERT_TRUE(joint.problem.solve());
    EXPECT_EQ(joint.count(0), 10);
    EXPECT_GE(joint.count(1), 7);
    EXPECT_EQ(joint.count(1), joint.count(2));
    for (std::size_t a = 0; a < joint.polyhedra.arcs.size(); ++a)
        EXPECT_EQ(joint.problem.pieces(std::int32_t(a)), joint.problem.pieces(joint.images.arc[a]));

    joint.problem.ask_nothing_yet();
    joint.problem.ask(0, 9, true, false);
    EXPECT_FALSE(joint.problem.solve());
}

}  // namespace
}  // namespace sinew::sqm
