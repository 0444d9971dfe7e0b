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

/// A dent in a ball of radius 1, `outside` above its surface.
Plain dented(double outside, double radius) {
    Document d;
    add(d, -1, {0, 0, 0}, 1, NodeType::ball);
    add(d, 0, {0, 0, 1 + outside}, radius, NodeType::negative);
    return extended(d);
}

TEST(ExtendPits, AreAsDeepAndWideAsDrawn) {
    const Plain plain = dented(0.4, 0.3);
    EXPECT_EQ(plain.cap[1], Cap::pit);
    EXPECT_NEAR(plain.pit_depth[1], 0.4, 1e-12);
    EXPECT_EQ(plain.form(1)->half.head<2>(), Vec2(0.3, 0.3));
    EXPECT_LT(distance(plain.position[1], {0, 0, 1.4}), 1e-12);
    EXPECT_EQ(plain.form(1)->sides, 8);
}

TEST(ExtendPits, MakeAJointOfTheLimbThatTheyArePressedInto) {
    Document d;
    add(d, -1, {0, 0, -4}, 1);
    add(d, 0, {0, 0, 0}, 1);
    add(d, 1, {0, 0, 4}, 1);
    add(d, 1, {0, 1.3, 0}, 0.3, NodeType::negative);
    const Plain plain = extended(d);
    ASSERT_TRUE(plain.form(1));
    EXPECT_EQ(plain.form(1)->kind, Form::Kind::blend);
    EXPECT_EQ(plain.form(1)->sides, 8);
    EXPECT_EQ(std::count(plain.cap.begin(), plain.cap.end(), Cap::surface), 3) << "its other bare sides";
}

TEST(ExtendPits, InsideTheirParentAreShallow) {
    const Plain plain = dented(-0.5, 0.3);
    EXPECT_NEAR(plain.pit_depth[1], 0.1 * 0.3, 1e-12);
    EXPECT_LT(distance(plain.position[1], {0, 0, 1.03}), 1e-12) << "and are moved outside";
}

TEST(ExtendPits, LeaveAWallBehindAndRoundThem) {
    EXPECT_NEAR(dented(5, 0.3).pit_depth[1], 0.85 * 2, 1e-12) << "of the thickness";
    EXPECT_NEAR(dented(1.69, 0.3).pit_depth[1], 1.69, 1e-12);
    EXPECT_EQ(dented(0.4, 3).form(1)->half.head<2>(), Vec2(0.9, 0.9)) << "of the radius";
    EXPECT_EQ(dented(0.4, 0.99).form(1)->half.head<2>(), Vec2(0.99, 0.99));
}

TEST(Extend, TubesLeaveBallsWithTheRadiusOfTheirOtherEnd) {
    Document d;
    add(d, -1, {0, 0, 0}, 1, NodeType::ball);
    add(d, 0, {0, 0, 3}, 0.6);
    add(d, 0, {0, 3, 0}, 5);
    add(d, 0, {0.5, 0, 0}, 0.8);  // inside the ball
    const Plain plain = extended(d);
    std::vector<Vec3> rings;
    for (std::int32_t i = 4; i < plain.node_count(); ++i)
        if (plain.form(i)) rings.push_back(plain.position[i]);
    ASSERT_EQ(rings.size(), 2u) << "none to the node inside";
    EXPECT_LT(distance(rings[0], {0, 0, 0.8}), 1e-12) << "where the ball is 0.6 wide";
    EXPECT_LT(distance(rings[1], {0, std::sqrt(1 - 0.9 * 0.9), 0}), 1e-12) << "0.9 of the ball at most";
}

TEST(Extend, BareAxesOfBallsGetBonesOfTheirOwn) {
    Document d;
    add(d, -1, {0, 0, 0}, 1, NodeType::ball);
    add(d, 0, {0, 0, 3}, 0.2);
    const auto bare_axes = [](const Plain& plain) {
        return std::count(plain.cap.begin(), plain.cap.end(), Cap::surface);
    };
    EXPECT_EQ(bare_axes(extended(d)), 5);
    add(d, 0, 3 * Vec3(std::sin(49 * M_PI / 180), 0, -std::cos(49 * M_PI / 180)), 0.2);
    EXPECT_EQ(bare_axes(extended(d)), 3) << "49 degrees from -z, and 41 from x";
    d.nodes[2].position = 3 * Vec3(1, 1, -1).normalized();
    EXPECT_EQ(bare_axes(extended(d)), 5) << "55 degrees from all";
}

TEST(ExtendPits, AreMeasuredFromTheSurfaceOfWhatTheyArePressedInto) {
    Document d;
    add(d, -1, {0, 0, 0}, 1, NodeType::ball).scale = {1, 1, 0.5};
    add(d, 0, {0, 0, 0.9}, 0.2, NodeType::negative);
    add(d, -1, {9, 0, 0}, 1, NodeType::cube).size = Vec3(2, 2, 3);
    add(d, 2, {9, 0, 1.7}, 0.2, NodeType::negative);
    const Plain plain = extended(d);
    EXPECT_NEAR(plain.pit_depth[1], 0.4, 1e-12) << "an ellipsoid 0.5 high";
    EXPECT_NEAR(plain.pit_depth[3], 0.2, 1e-12) << "a box 1.5 high";
}

TEST(ExtendCubes, RoundTubesEndOnAPlateHoweverWide) {
    for (const double radius : {0.2, 0.5, 3.0}) {
        Document d;
        add(d, -1, {0, 0, 0}, radius, NodeType::cube).size = Vec3(1, 1, 1);
        add(d, 0, {0, 0, 4}, radius);
        const Plain plain = extended(d);
        const auto plate = std::find(plain.bones[0].begin(), plain.bones[0].end(), 0) == plain.bones[0].end()
                               ? plain.bones[0][0]
                               : 0;
        ASSERT_TRUE(plain.form(plate));
        EXPECT_EQ(plain.form(plate)->section, Section::round);
        EXPECT_NEAR(plain.form(plate)->half.x(), std::min(radius, 0.9 * 0.5), 1e-12);
        EXPECT_NEAR(plain.position[plate].z(), 0.5, 1e-6) << "on the face";
    }
}

TEST(ExtendCubes, ABallInsideOnAPathComesOutOfTheFace) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.2, NodeType::cube).size = Vec3(1, 1, 1);
    add(d, 0, {0, 0, 0.2}, 0.2);
    add(d, 1, {0, 0, 4}, 0.2);
    EXPECT_NEAR(extended(d).position[1].z(), 0.5 + 0.2, 1e-6);
}

TEST(ExtendCubes, ABallInsideAtAnEndIsAPartOfTheFace) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.2, NodeType::cube).size = Vec3(1, 1, 1);
    add(d, 0, {0, 0, 0.2}, 0.1);
    const Plain plain = extended(d);
    EXPECT_EQ(plain.cap[1], Cap::flat);
    EXPECT_NEAR(plain.position[1].z(), 0.5, 1e-6);
    d.nodes[1].position.z() = 0.45;  // and stands out of it where it reaches through
    EXPECT_EQ(extended(d).cap[1], Cap::round);
}

TEST(Extend, ANegativeOnAPathIsABallLikeAnyOther) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.2);
    add(d, 0, {0, 0, 2}, 0.3, NodeType::negative);
    add(d, 1, {0, 0, 4}, 0.2);
    const Plain plain = extended(d);
    EXPECT_EQ(plain.form(1), nullptr);
    EXPECT_EQ(plain.node_count(), 3);
}

TEST(ExtendCubes, PlatesStandBeforeTheOtherEndAsFarAsTheyFit) {
    for (const int axis : {0, 1}) {
        Document d;
        add(d, -1, {0, 0, 0}, 0.18, NodeType::cube).size = Vec3(1, 1, 1);
        add(d, 0, {0, 0, 4}, 0.18);
        const auto plate_at = [&](double aside) {
            d.nodes[1].position[axis] = aside;
            const Plain plain = extended(d);
            return plain.position[plain.bones[0][0]][axis];
        };
        EXPECT_NEAR(plate_at(0.2), 0.2, 1e-9);
        EXPECT_NEAR(plate_at(0.45), 0.3, 1e-9) << "0.18 / 0.9 from the edge";
        EXPECT_NEAR(plate_at(-0.45), -0.3, 1e-9);
        EXPECT_NEAR(plate_at(0.7), 0, 1e-9) << "not before the face at all";
        d.nodes[0].radius = 0.47;
        EXPECT_NEAR(plate_at(0.3), 0, 1e-9) << "no room to either side";
    }
}

TEST(ExtendCubes, BeamsWiderThanTheFaceAreMadeToFitIt) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.2, NodeType::cube).size = Vec3(1, 1, 1);
    Node& beam = add(d, 0, {0, 0, 4}, 0.4);
    beam.section = Section::rectangular;
    beam.scale = {2, 1, 1};
    const Plain plain = extended(d);
    const Form* plate = plain.form(plain.bones[0][0]);
    ASSERT_TRUE(plate);
    EXPECT_EQ(plate->section, Section::rectangular);
    EXPECT_LT((plate->half.head<2>() - Vec2(0.98 * 0.5, 0.4)).norm(), 1e-12);
}

TEST(ExtendCubes, ASmallerCubeOnAFaceIsFlatWithIt) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.5, NodeType::cube);
    add(d, 0, {0, 0, 0.75}, 0.25, NodeType::cube);
    EXPECT_EQ(extended(d).bone_kind[0], BoneKind::body) << "on a joint, the root";
    add(d, 1, {0, 0, 1.125}, 0.125, NodeType::cube);
    EXPECT_EQ(extended(d).bone_kind[1], BoneKind::plate) << "on a path";
}

TEST(Extend, LoneNodesAreBallsAndBoxesOfTheirScale) {
    Document d;
    add(d, -1, {0, 0, 0}, 1);
    add(d, -1, {5, 0, 0}, 2).scale = {1, 2, 3};
    add(d, -1, {20, 0, 0}, 2).section = Section::rectangular;
    const Plain plain = extended(d);
    EXPECT_EQ(plain.form(0), nullptr);
    EXPECT_EQ(plain.form(1)->kind, Form::Kind::ball);
    EXPECT_EQ(plain.form(1)->half, Vec3(2, 4, 6));
    EXPECT_EQ(plain.form(2)->kind, Form::Kind::box);
}

TEST(Extend, SoftJointsHaveAFormToo) {
    Document d;
    add(d, -1, {0, 0, 0}, 1);
    add(d, 0, {0, 0, 4}, 1).joint = 0.5;
    add(d, 1, {0, 0, 8}, 1);
    const Plain plain = extended(d);
    ASSERT_TRUE(plain.form(1));
    EXPECT_EQ(plain.form(1)->sharpness, 0.5);
    EXPECT_EQ(plain.form(0), nullptr);
}

}  // namespace
}  // namespace sinew
