#include "sinew/extend/builder.h"

#include "building.h"

namespace sinew {
namespace {

using namespace testing_types;

TEST(Builder, PartsNodesAtOnePlaceByAHairAlongTheBoneBefore) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.5);
    add(d, 0, {2, 0, 0}, 0.5);
    add(d, 1, {2, 0, 0}, 0.4, NodeType::cube);
    const Built b(d);
    EXPECT_EQ(b.builder.position(1), Vec3(2, 0, 0));
    EXPECT_NEAR(b.builder.position(2).x() - 2, 1e-6 * 0.4, 1e-12);
    EXPECT_LT((b.builder.direction(1, 2) - Vec3::UnitX()).norm(), 1e-6) << "and the bone has a direction";
}

TEST(Builder, PartsNodesAtOnePlaceUpwardsWhereNoBoneComesBefore) {
    Document d;
    add(d, -1, {1, 2, 3}, 0.5, NodeType::cube);
    add(d, 0, {1, 2, 3}, 0.5, NodeType::hemisphere);
    const Built b(d);
    EXPECT_EQ(b.builder.direction(0, 1), Vec3::UnitZ());
}

TEST(Builder, LeavesNodesThatAreApart) {
    Document d;
    add(d, -1, {0, 0, 0}, 1);
    add(d, 0, {0, 1e-6, 0}, 1);
    const Built b(d);
    EXPECT_EQ(b.builder.position(1), Vec3(0, 1e-6, 0));
}

TEST(Builder, TellsPlainBalls) {
    Document d;
    for (int i = 0; i < 5; ++i) add(d, -1, {4.0 * i, 0, 0}, 1);
    d.nodes[1].section = Section::rectangular;
    d.nodes[2].scale = {1, 1, 2};
    d.nodes[3].joint = 1;
    d.nodes[4].type = NodeType::ball;
    const Built b(d);
    EXPECT_TRUE(b.builder.is_plain_ball(0));
    for (int i = 1; i < 5; ++i) EXPECT_FALSE(b.builder.is_plain_ball(i)) << i;
}

TEST(Builder, OfTwoNegativesAlonePressesTheSecondIntoTheFirst) {
    Document d;
    add(d, -1, {0, 0, 0}, 1, NodeType::negative);
    add(d, 0, {0, 0, 2}, 1, NodeType::negative);
    const Built b(d);
    EXPECT_FALSE(b.builder.is_pit(0));
    EXPECT_TRUE(b.builder.is_pit(1));
}

TEST(Builder, NegativesAreDentsAtLeavesOnly) {
    Document d;
    add(d, -1, {0, 0, 0}, 1);
    add(d, 0, {0, 0, 2}, 1, NodeType::negative);
    add(d, 1, {0, 0, 4}, 1, NodeType::negative);
    add(d, -1, {9, 0, 0}, 1, NodeType::negative);
    const Built b(d);
    EXPECT_FALSE(b.builder.is_pit(0));
    EXPECT_FALSE(b.builder.is_pit(1)) << "has two bones";
    EXPECT_TRUE(b.builder.is_pit(2)) << "in a negative that is none itself";
    EXPECT_FALSE(b.builder.is_pit(3)) << "has none";
}

TEST(Builder, NegativesAreDentsInWhateverOrderTheyAreWritten) {
    Document d;
    add(d, -1, {0, 0, 0}, 1);
    add(d, 2, {0, 0, 4}, 1, NodeType::negative);
    add(d, 0, {0, 0, 2}, 1, NodeType::negative);  // has two bones
    const Built b(d);
    EXPECT_TRUE(b.builder.is_pit(1));
    EXPECT_FALSE(b.builder.is_pit(2));
}

TEST(Builder, TheFirstBoneIsThatToTheParent) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.2);
    add(d, 3, {4, 0, 0}, 0.2);
    add(d, 3, {2, 2, 0}, 0.2);
    add(d, 0, {2, 0, 0}, 0.2);
    const Built b(d);
    EXPECT_EQ(b.builder.other(b.builder.first_bone(3), 3), 0);
    EXPECT_EQ(b.builder.other(b.builder.first_bone(1), 1), 3);
    EXPECT_EQ(b.builder.other(b.builder.first_bone(0), 0), 3) << "a root's only one";
    EXPECT_TRUE(b.builder.is_below(1, 3));
    EXPECT_FALSE(b.builder.is_below(3, 1));
    EXPECT_TRUE(b.builder.is_root(0));
    EXPECT_FALSE(b.builder.is_root(3));
}

TEST(Builder, FramesLeadAwayFromTheRoot) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.2);
    add(d, 0, {0, 2, 0}, 0.2);
    add(d, 1, {0, 2, 2}, 0.2);
    const Built b(d);
    EXPECT_LT(distance(b.builder.frame(0).z, {0, 1, 0}), 1e-12);
    EXPECT_LT(distance(b.builder.frame(1).z, Vec3(0, 1, 1).normalized()), 1e-12) << "the bisector";
    EXPECT_LT(distance(b.builder.frame(2).z, {0, 0, 1}), 1e-12);
}

TEST(Builder, DrawnBonesComeFirstAndAreTiedToWhereTheyWereAttached) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.2);
    add(d, 0, {0, 0, 2}, 0.3);
    Built b(d);
    const std::int32_t more = b.builder.add_node({0, 0, 1}, 0.1, 1);
    b.builder.add_bone(1, more, BoneKind::plate);
    b.builder.attach(0, 1, more);
    b.builder.set_kind(0, BoneKind::side);
    const Plain plain = b.builder.finish();
    EXPECT_EQ(plain.bones, (std::vector<Bone>{{0, more}, {1, more}}));
    EXPECT_EQ(plain.bone_kind, (std::vector<BoneKind>{BoneKind::side, BoneKind::plate}));
    EXPECT_EQ(plain.source_bone, (std::vector<std::int32_t>{0, -1})) << "nobody drew the second";
    EXPECT_EQ(plain.source_node, (std::vector<std::int32_t>{0, 1, 1}));
    EXPECT_EQ(plain.radius[more], 0.1);
    EXPECT_EQ(plain.cap[more], Cap::round);
    EXPECT_EQ(plain.form(more), nullptr);
}

TEST(Builder, WarningsNameTheNode) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.2).id = 77;
    Built b(d);
    b.builder.warn(0, "is odd");
    ASSERT_EQ(b.warnings.size(), 1u);
    EXPECT_EQ(b.warnings[0].message, "node 77: is odd");
    EXPECT_THAT(b.warnings[0].nodes, testing::ElementsAre(77));
}

}  // namespace
}  // namespace sinew
