#include "sinew/grow/turtle.h"

#include <gmock/gmock.h>

#include "grow/grow_testing.h"
#include "sinew/skeleton/frames.h"

namespace sinew {
namespace {

using sinew::testing::grown;

Vec3 end_of(const std::string& axiom) { return grown("%angle 90\n%axiom " + axiom).nodes.back().position; }

TEST(Turtle, TurnsAsTheWordsSay) {
    EXPECT_EQ(end_of("F"), Vec3(0, 0, 1));    // heading +z
    EXPECT_EQ(end_of("+F"), Vec3(-1, 0, 0));  // left -x
    EXPECT_EQ(end_of("-F"), Vec3(1, 0, 0));
    EXPECT_EQ(end_of("^F"), Vec3(0, -1, 0));  // up -y, towards who looks
    EXPECT_EQ(end_of("&F"), Vec3(0, 1, 0));
    EXPECT_EQ(end_of("|F"), Vec3(0, 0, -1));
    EXPECT_EQ(end_of("/+F"), Vec3(0, -1, 0));  // rolled right, left is up
    EXPECT_EQ(end_of("\\+F"), Vec3(0, 1, 0));
    EXPECT_EQ(end_of("+F+F+F+F"), Vec3(0, 0, 0));
    EXPECT_TRUE(end_of("+(30) F(2)").isApprox(Vec3(-1, 0, std::sqrt(3)), 1e-15));
    EXPECT_EQ(end_of("F(-2)"), Vec3(0, 0, -2));
}

TEST(Turtle, LevelsItself) {
    // Whatever the roll, after $ the left is horizontal, and up points upwards.
    for (const char* turns : {"&(30)/(50)", "+(20)\\(130)^(60)", "^(100)/(10)+(45)"}) {
        const Document d = grown(std::string("%axiom ") + turns + "$ [F] [+F] [^F]");
        const Vec3 heading = d.nodes[1].position, left = d.nodes[2].position, up = d.nodes[3].position;
        EXPECT_NEAR(left.z(), 0, 1e-15);
        EXPECT_GT(up.z(), 0);
        EXPECT_TRUE(up.isApprox(heading.cross(left), 1e-14));
    }
}

TEST(Turtle, BendsTowardsTropism) {
    // Across T, the first turn is e radians.
    const Document d = grown("%tropism 0, 0, -1, 0.22\n%axiom -F F\n");
    EXPECT_TRUE(d.nodes[2].position.isApprox(Vec3(1 + std::cos(0.22), 0, -std::sin(0.22)), 1e-14));
    EXPECT_EQ(end_of("@tropism(0.5) F F"), Vec3(0, 0, 2));  // along T nothing turns it
    EXPECT_TRUE(end_of("@tropism(1, 0, 0, 1) F F").isApprox(Vec3(std::sin(1), 0, 1 + std::cos(1)), 1e-14));
}

TEST(Turtle, SharesNodesWhereSegmentsMeet) {
    EXPECT_EQ(grown("%axiom F[+F][-F]F\n").nodes.size(), 5u);
    EXPECT_EQ(grown("%axiom [+F][-F]F\n").nodes.size(), 4u);
    EXPECT_EQ(grown("%axiom f[[+F][-F]]F\n").nodes.size(), 4u);
    EXPECT_EQ(grown("%axiom F F(0) [F(0)] F\n").nodes.size(), 3u);
    EXPECT_EQ(grown("%axiom F f(0) F\n").nodes.size(), 3u);
}

TEST(Turtle, RefusesBranchesWithoutEnd) {
    EXPECT_NE(sinew::testing::error_of("%axiom F A\n%steps 3000000\nA -> [A]\n"), "");
}

TEST(Turtle, LeavesAGapWhereItMovesOnly) {
    const Document d = grown("%axiom F f F f f . f\n");
    ASSERT_EQ(d.nodes.size(), 5u);
    EXPECT_EQ(d.nodes[2].parent, -1);
    EXPECT_EQ(d.nodes[2].position, Vec3(0, 0, 2));
    EXPECT_EQ(d.nodes[4].parent, -1);
    EXPECT_EQ(d.nodes[4].position, Vec3(0, 0, 5));
}

TEST(Turtle, GivesASegmentsRadiusToItsEnd) {
    const Document d = grown("%radius 4\n%thinning 0.5\n%axiom F [!F [!(7) F] F] F\n");
    std::vector<double> radii;
    for (const Node& node : d.nodes) radii.push_back(node.radius);
    EXPECT_EQ(radii, (std::vector<double>{4, 4, 2, 7, 2, 4}));
}

TEST(Turtle, SetsTheTypeOfTheNextNodeOnly) {
    const Document d = grown("%axiom @cube(1, 2, 3) @joint(2) F @ball @sharp F @ball . F\n");
    EXPECT_EQ(d.nodes[0].type, NodeType::sphere);
    EXPECT_EQ(d.nodes[1].type, NodeType::cube);
    EXPECT_EQ(*d.nodes[1].size, Vec3(1, 2, 3));
    EXPECT_EQ(d.nodes[1].joint, 2);
    EXPECT_EQ(d.nodes[2].type, NodeType::ball);
    EXPECT_EQ(d.nodes[2].joint, infinitely_sharp);
    EXPECT_EQ(d.nodes[3].type, NodeType::ball);  // the . found a node already and changed nothing
    EXPECT_EQ(d.nodes[3].joint, 0);
}

TEST(Turtle, KeepsLeafTypesForLeaves) {
    const Document d = grown("%axiom @cone F @cone F [+ @hemisphere F] [- @negative F]\n");
    EXPECT_EQ(d.nodes[1].type, NodeType::sphere);
    EXPECT_EQ(d.nodes[2].type, NodeType::sphere);
    EXPECT_EQ(d.nodes[3].type, NodeType::hemisphere);
    EXPECT_EQ(d.nodes[4].type, NodeType::negative);
}

TEST(Turtle, KeepsSectionAndScaleOfThePenUntilTheBranchEnds) {
    const Document d = grown("%axiom F [@rectangular @scale(2, 0.5) +F F] @scale(1, 1, 3) F\n");
    EXPECT_EQ(d.nodes[1].section, Section::round);
    for (int i : {2, 3}) {
        EXPECT_EQ(d.nodes[i].section, Section::rectangular);
        EXPECT_EQ(d.nodes[i].scale, (std::array<double, 3>{2, 0.5, 1}));
    }
    EXPECT_EQ(d.nodes[4].section, Section::round);
    EXPECT_EQ(d.nodes[4].scale, (std::array<double, 3>{1, 1, 3}));
}

TEST(Turtle, WritesItsFrameIntoNodes) {
    for (const char* turns : {"+(20)", "-(90)/(33)", "&(40)\\(77)+(10)", "|^(5)/(200)"}) {
        // Cubes at the root, at a branch and at a leaf. The bones at the root and at the branch show left,
        // up, heading.
        const Document d =
            grown(std::string("%axiom ") + turns + "@cube . [+F] [^F] @cube F [+F] [^F] @rectangular F F");
        const auto bones = bones_of(d);
        const Adjacency neighbours = adjacency(static_cast<std::int32_t>(d.nodes.size()), bones);
        Mat3 turtle;
        turtle << d.nodes[1].position, d.nodes[2].position, d.nodes[3].position;
        for (int node : {0, 3, 6, 7})
            EXPECT_TRUE(local_frame(d, bones, neighbours, node).isApprox(turtle, 1e-12)) << turns << node;
    }
}

}  // namespace
}  // namespace sinew
