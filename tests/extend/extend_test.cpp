#include "sinew/extend/extend.h"

#include "building.h"

namespace sinew {
namespace {

using namespace testing_types;

Plain extended(const Document& document) {
    Warnings warnings;
    return extend(document, condition(document), warnings);
}

TEST(Extend, LeavesPlainBallsAsTheyAre) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.5);
    add(d, 0, {0, 0, 2}, 0.4);
    add(d, 1, {0, 1, 3}, 0.3);
    const Plain plain = extended(d);
    EXPECT_EQ(plain.radius, (std::vector<double>{0.5, 0.4, 0.3}));
    EXPECT_EQ(plain.bones, (std::vector<Bone>{{0, 1}, {1, 2}}));
    EXPECT_TRUE(plain.forms.empty());
    EXPECT_THAT(plain.bone_kind, testing::Each(BoneKind::tube));
}

TEST(Extend, PutsARingOfTheMeanRadiusBetweenTwoConesThatLookAtEachOther) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.5, NodeType::cone);
    add(d, 0, {0, 0, 3}, 0.3, NodeType::cone);
    const Plain plain = extended(d);
    ASSERT_EQ(plain.node_count(), 3);
    EXPECT_EQ(plain.position[2], Vec3(0, 0, 1.5));
    EXPECT_DOUBLE_EQ(plain.radius[2], 0.4);
    EXPECT_EQ(plain.cap[0], Cap::point);
    EXPECT_EQ(plain.cap[1], Cap::point);
    EXPECT_EQ(plain.cap[2], Cap::round);
    EXPECT_EQ(plain.bones, (std::vector<Bone>{{0, 2}, {2, 1}}));
    EXPECT_EQ(plain.source_bone, (std::vector<std::int32_t>{0, 0}))
        << "both halves are the bone that was drawn";
}

TEST(Extend, LeavesAConeOnAPathAlone) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.5, NodeType::cone);
    add(d, 0, {0, 0, 3}, 0.3);
    EXPECT_EQ(extended(d).node_count(), 2);
}

TEST(Extend, FillsEveryArrayAndGivesEveryBoneALength) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.5, NodeType::cube);
    add(d, 0, {0, 0, 4}, 0.5, NodeType::ball);
    add(d, 1, {0, 3, 4}, 0.2, NodeType::cube);
    add(d, 1, {0, 0, 4.8}, 0.2, NodeType::negative);
    add(d, 1, {4, 0, 4}, 0.2).section = Section::rectangular;
    const Plain plain = extended(d);
    const auto nodes = plain.position.size(), bones = plain.bones.size();
    for (const std::size_t size : {plain.radius.size(), plain.cap.size(), plain.form_of.size(),
                                   plain.pit_depth.size(), plain.source_node.size()})
        EXPECT_EQ(size, nodes);
    for (const std::size_t size : {plain.bone_kind.size(), plain.source_bone.size()}) EXPECT_EQ(size, bones);
    for (const Bone& bone : plain.bones)
        EXPECT_GT(distance(plain.position[bone[0]], plain.position[bone[1]]), 0);
}

}  // namespace
}  // namespace sinew
