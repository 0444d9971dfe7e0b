#include "sinew/skeleton/frames.h"

#include <gtest/gtest.h>

namespace sinew {
namespace {

Mat3 frame_of(const Document& document, std::int32_t node) {
    const std::vector<Bone> bones = bones_of(document);
    return local_frame(document, bones, adjacency(static_cast<std::int32_t>(document.nodes.size()), bones),
                       node);
}

/// The axes agree up to their signs, which no section shows.
bool same_axes(const Mat3& a, const Mat3& b) { return Mat3((a.transpose() * b).cwiseAbs()).isIdentity(1e-9); }

TEST(LocalFrame, OfABodyTurnsByRotationThenRoll) {
    Node node{.type = NodeType::cube, .roll = 90};
    node.rotation = Quat(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitX()));
    const Mat3 f = local_frame(node, {.degree = 3});
    EXPECT_LT((f.col(2) + Vec3::UnitY()).norm(), 1e-12);
    EXPECT_LT((f.col(0) - Vec3::UnitZ()).norm(), 1e-12);
}

TEST(LocalFrame, RollsARootAsTheRestOfItsBeam) {
    const Vec3 step(1, -2, 0.5);
    Document beam{.nodes = {{.id = 1, .roll = 30},
                            {.id = 2, .parent = 0, .position = step, .roll = 30},
                            {.id = 3, .parent = 1, .position = 3 * step, .roll = 30}}};
    EXPECT_TRUE(same_axes(frame_of(beam, 0), frame_of(beam, 2)));
    EXPECT_TRUE(same_axes(frame_of(beam, 1), frame_of(beam, 2)));
    beam.nodes.push_back({.id = 4, .parent = 0, .position = -step, .roll = 30});  // a root in the middle
    EXPECT_TRUE(same_axes(frame_of(beam, 0), frame_of(beam, 2)));
}

TEST(LocalFrame, OfARootThatBranchesIsTheWorlds) {
    Document star{.nodes = {{.id = 1}}};
    for (int i = 0; i < 3; ++i) star.nodes.push_back({.id = 2 + i, .parent = 0, .position = Vec3(i, 1, 2)});
    EXPECT_TRUE(frame_of(star, 0).isIdentity());
    star.nodes[0].rotation = Quat(Eigen::AngleAxisd(0.3, Vec3::UnitY()));
    EXPECT_TRUE(frame_of(star, 0).isApprox(star.nodes[0].rotation->toRotationMatrix(), 1e-12));
}

TEST(LocalFrame, TakesARotationWhereNoBonesDecide) {
    const Node ball{.parent = 0, .type = NodeType::ball}, sphere{.parent = 0};
    const Node root_ball{.type = NodeType::ball}, root;
    for (const Node* node : {&ball, &sphere, &root_ball, &root}) {
        EXPECT_TRUE(takes_rotation(*node, 0));
        EXPECT_TRUE(takes_rotation(*node, 3));
        EXPECT_EQ(takes_rotation(*node, 1), node == &root_ball);
        EXPECT_EQ(takes_rotation(*node, 2), node == &root_ball);
    }
}

}  // namespace
}  // namespace sinew
