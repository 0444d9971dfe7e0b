#include "sinew/skeleton/edit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "fixed_seed.h"
#include "sinew/skeleton/frames.h"
#include "sinew/skeleton/graph.h"
#include "sinew/skeleton/validate.h"

namespace sinew {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using testing::UnorderedElementsAre;

std::vector<std::int32_t> parents(const Document& document) {
    std::vector<std::int32_t> result;
    for (const Node& node : document.nodes) result.push_back(node.parent);
    return result;
}

GraphCounts counts(const Document& document) {
    return count_graph(static_cast<std::int32_t>(document.nodes.size()), bones_of(document));
}

/// Ids 10 ...; a trunk 0 - 1 with two leaves 2, 3 at its end.
Document trunk_with_leaves() {
    Document document;
    document.nodes = {{.position = {0, 0, 0}, .radius = 2},
                      {.parent = 0, .position = {0, 0, 10}, .radius = 2},
                      {.parent = 1, .position = {4, 0, 13}, .radius = 1},
                      {.parent = 1, .position = {-4, 0, 13}, .radius = 1, .type = NodeType::cone}};
    for (std::size_t i = 0; i < 4; ++i) document.nodes[i].id = 10 + static_cast<std::int64_t>(i);
    document.names = {"root", "fork", "right", "left"};
    return document;
}

TEST(Edit, NodesAreFoundByTheirIds) {
    EXPECT_EQ(node_with_id(trunk_with_leaves(), 12).value(), 2);
    EXPECT_EQ(node_with_id(trunk_with_leaves(), 2).error().kind, ErrorKind::call);
}

TEST(Edit, ConsolidatedLeavesKeepTheRadiusUntilNearTheTip) {
    const Document d =
        consolidate_leaves(trunk_with_leaves(), {.distance = 1}, std::vector<std::int32_t>{0, 1, 2});
    ASSERT_THAT(d.nodes, SizeIs(6));
    EXPECT_TRUE(validate(d));
    EXPECT_EQ(d.nodes[4].position, Vec3(0, 0, 2));  // the root is a leaf too
    EXPECT_THAT(parents(d), ElementsAre(-1, 4, 5, 1, 0, 1));
    EXPECT_TRUE(d.nodes[5].position.isApprox(Vec3(4, 0, 13) - Vec3(0.8, 0, 0.6)));
    EXPECT_EQ(d.nodes[5].radius, 2);
    EXPECT_THAT(d.names, SizeIs(6));
}

TEST(Edit, ConsolidatedNodesStayOnTheirSideOfAShortBone) {
    Document stick{
        .nodes = {{.id = 0, .radius = 9}, {.id = 1, .parent = 0, .position = {0, 0, 5}, .radius = 9}}};
    const Document d = consolidate_leaves(stick);
    EXPECT_THAT(parents(d), ElementsAre(-1, 3, 0, 2));
    EXPECT_DOUBLE_EQ(d.nodes[2].position.z(), 2);
    EXPECT_DOUBLE_EQ(d.nodes[3].position.z(), 3);
}

TEST(Edit, MergedTwinsShareOneBone) {
    const Document d =
        merge_nodes(trunk_with_leaves(), std::vector<std::array<std::int32_t, 2>>{{3, 2}}).value();
    ASSERT_THAT(d.nodes, SizeIs(3));
    EXPECT_EQ(d.nodes[2].position, Vec3(0, 0, 13));
    EXPECT_EQ(d.nodes[2].id, 12);
    EXPECT_THAT(bones_of(d), ElementsAre(Bone{0, 1}, Bone{1, 2}));
    EXPECT_THAT(d.names, ElementsAre("root", "fork", "right"));
}

TEST(Edit, MergedLeavesOfOneTreeCloseACycle) {
    const Document d =
        merge_nodes(trunk_with_leaves(), std::vector<std::array<std::int32_t, 2>>{{0, 3}}).value();
    EXPECT_TRUE(validate(d));
    EXPECT_THAT(d.nodes, SizeIs(3));
    EXPECT_EQ(counts(d).cycles, 0);  // the bones 0 - 1 and 1 - 3 are one now
    Document longer = insert_on_bone(trunk_with_leaves(), 2, 0.5).value();
    const Document ring = merge_nodes(longer, std::vector<std::array<std::int32_t, 2>>{{0, 3}}).value();
    EXPECT_TRUE(validate(ring));
    EXPECT_EQ(counts(ring).cycles, 1);
    EXPECT_EQ(counts(ring).components, 1);
}

TEST(Edit, WhatCannotBeMergedIsTheCallsFault) {
    using Pairs = std::vector<std::array<std::int32_t, 2>>;
    EXPECT_EQ(merge_nodes(trunk_with_leaves(), Pairs{{1, 1}}).error().kind, ErrorKind::call);
    EXPECT_EQ(merge_nodes(trunk_with_leaves(), Pairs{{1, 9}}).error().kind, ErrorKind::call);
}

TEST(Edit, CloseLeavesArePairedClosestFirst) {
    Document d = trunk_with_leaves();
    d.nodes.push_back({.id = 20, .parent = 0, .position = {5, 0, 13}});
    EXPECT_THAT(close_leaves(d, 0.5), IsEmpty());
    EXPECT_THAT(close_leaves(d, 8), ElementsAre(std::array{2, 4}));
    EXPECT_THAT(close_leaves(d, 100),
                ElementsAre(std::array{2, 4}));  // 3 and the root have bones left, but 0 has two
}

TEST(Edit, ANodeOnABoneInterpolates) {
    const Document d = insert_on_bone(trunk_with_leaves(), 1, 0.25).value();
    EXPECT_THAT(parents(d), ElementsAre(-1, 0, 4, 1, 1));
    EXPECT_EQ(d.nodes[4].position, Vec3(1, 0, 10.75));
    EXPECT_EQ(d.nodes[4].radius, 1.75);
    EXPECT_EQ(d.nodes[4].id, 14);
    EXPECT_FALSE(insert_on_bone(trunk_with_leaves(), 3));
    EXPECT_FALSE(insert_on_bone(trunk_with_leaves(), 0, 1.5));
}

TEST(Edit, ANodeOnALinkSplitsIt) {
    Document d = trunk_with_leaves();
    d.nodes[3].type = NodeType::sphere;
    d.links = {{2, 3}};
    d = insert_on_bone(d, 3).value();
    EXPECT_TRUE(validate(d));
    EXPECT_THAT(bones_of(d),
                UnorderedElementsAre(Bone{0, 1}, Bone{1, 2}, Bone{1, 3}, Bone{2, 4}, Bone{4, 3}));
}

TEST(Edit, DissolvingJoinsWhatANodeJoined) {
    const Document d = dissolve(trunk_with_leaves(), std::vector<std::int32_t>{1});
    EXPECT_THAT(parents(d), ElementsAre(-1, 0, 0));
    EXPECT_EQ(d.nodes[1].id, 12);
    const Document without_root = dissolve(trunk_with_leaves(), std::vector<std::int32_t>{0});
    EXPECT_THAT(parents(without_root), ElementsAre(-1, 0, 0));
    const Document without_trunk = dissolve(trunk_with_leaves(), std::vector<std::int32_t>{0, 1});
    EXPECT_THAT(parents(without_trunk), ElementsAre(-1, 0));
    EXPECT_THAT(dissolve(trunk_with_leaves(), std::vector<std::int32_t>{0, 1, 2, 3}).nodes, IsEmpty());
    EXPECT_THAT(dissolve(trunk_with_leaves(), {}).nodes, SizeIs(4));
}

TEST(Edit, ANewRootTurnsTheWayToTheOldOne) {
    const Document d = reroot(trunk_with_leaves(), 2);
    EXPECT_THAT(parents(d), ElementsAre(1, 2, -1, 1));
    EXPECT_TRUE(validate(d));
}

TEST(Edit, BoxesStayAsTheyAreUnderANewRoot) {
    Document d = trunk_with_leaves();
    d.nodes[0].type = d.nodes[1].type = d.nodes[2].type = NodeType::cube;
    d.nodes[2].roll = 17;
    Document longer = insert_on_bone(d, 1).value();
    longer.nodes[4].type = NodeType::cube;
    longer.nodes[4].roll = 25;
    const Document turned = reroot(longer, 2);
    auto frame = [](const Document& document, std::int32_t node) {
        const std::vector<Bone> bones = bones_of(document);
        return local_frame(document, bones, adjacency(5, bones), node);
    };
    for (std::int32_t i : {1, 2, 4})  // the old root may roll only
        EXPECT_TRUE((frame(turned, i).transpose() * frame(longer, i)).cwiseAbs().isIdentity(1e-9)) << i;
    EXPECT_EQ(turned.nodes[4].roll, -25);
}

TEST(Edit, AMirroredDocumentHasBothHalves) {
    Document half = trunk_with_leaves();
    const Document d = mirror(half, 1);
    EXPECT_THAT(d.nodes, SizeIs(4));  // all on the plane y = 0
    for (Node& node : half.nodes) node.position.y() += 1;
    EXPECT_THAT(mirror(half, 1).nodes, SizeIs(8));
    EXPECT_EQ(mirror(half, 1).nodes[6].position, Vec3(4, -1, 13));
    half.symmetry = {Symmetry::Kind::mirror, 0, 1};
    EXPECT_THAT(mirror(half, 1).nodes, SizeIs(8));  // left and right are each other's images already
}

TEST(Edit, RadialCopiesShareTheAxis) {
    const Document d = radial_copy(trunk_with_leaves(), 2, 8);
    EXPECT_TRUE(validate(d));
    // The trunk is on the axis; left and right leaf stand at each other's fourth image.
    EXPECT_THAT(d.nodes, SizeIs(2 + 8));
    EXPECT_THAT(radial_copy(trunk_with_leaves(), 2, 1).nodes, SizeIs(4));
}

TEST(Edit, NodesSnapToTheGrid) {
    Document d = trunk_with_leaves();
    d.nodes[2].position = {0.3, -0.1, 1.26};
    const Document snapped = snap_to_grid(d, 0.25, std::vector<std::int32_t>{2});
    EXPECT_EQ(snapped.nodes[2].position, Vec3(0.25, 0, 1.25));
    EXPECT_FALSE(std::signbit(snapped.nodes[2].position.y()));
    EXPECT_EQ(snapped.nodes[3].position, d.nodes[3].position);
}

TEST(Edit, BonesSnapToAnglesExactlyAndCarryWhatHangsAtThem) {
    Document d{.nodes = {{.id = 0},
                         {.id = 1, .parent = 0, .position = {3.1, 2.9, 0.1}},
                         {.id = 2, .parent = 1, .position = {3.1, 2.9, 5}}}};
    const Document snapped = snap_to_angle(d, 45, std::vector<std::int32_t>{1}).value();
    const Vec3 tip = snapped.nodes[1].position;
    EXPECT_EQ(tip.x(), tip.y());
    EXPECT_EQ(tip.z(), 0);
    EXPECT_DOUBLE_EQ(tip.norm(), d.nodes[1].position.norm());
    EXPECT_TRUE((snapped.nodes[2].position - tip).isApprox(Vec3(0, 0, 4.9)));
    EXPECT_EQ(snap_to_angle(d, 90).value().nodes[2].position.x(),
              snap_to_angle(d, 90).value().nodes[1].position.x());
    EXPECT_FALSE(snap_to_angle(d, 7));
    EXPECT_FALSE(snap_to_angle(d, 0));
}

/// Any tree with leaves of all types, and a link.
Document any_document() {
    Document d;
    const int count = *rc::gen::inRange(1, 12);
    for (int i = 0; i < count; ++i)
        d.nodes.push_back(
            {.id = 3 * i,
             .parent = *rc::gen::inRange(-1, i),
             .position = Vec3(*rc::gen::inRange(-3, 4), *rc::gen::inRange(-3, 4), *rc::gen::inRange(-3, 4)),
             .radius = *rc::gen::inRange(1, 9) / 4.0,
             .roll = static_cast<double>(*rc::gen::inRange(0, 90))});
    if (count > 3 && d.nodes[3].parent != 0 && d.nodes[0].parent != 3) d.links = {{0, 3}};
    const std::vector<Bone> bones = bones_of(d);
    const Adjacency around = adjacency(count, bones);
    for (int i = 0; i < count; ++i) {
        const bool free = around.degree(i) == 1 &&
                          around.degree(bones[around.bones(i)[0]][0] + bones[around.bones(i)[0]][1] - i) > 1;
        d.nodes[i].type = free ? *rc::gen::element(NodeType::cone, NodeType::negative, NodeType::hemisphere)
                               : *rc::gen::element(NodeType::sphere, NodeType::cube, NodeType::ball);
    }
    return d;
}

RC_GTEST_PROP(EditProperty, WhatIsValidStaysValid, ()) {
    const Document d = any_document();
    RC_PRE(validate(d).has_value());
    const auto count = static_cast<std::int32_t>(d.nodes.size());
    const std::int32_t a = *rc::gen::inRange(0, count), b = *rc::gen::inRange(0, count);
    const GraphCounts before = counts(d);
    auto check = [](const Document& after) {
        const Result<void> valid = validate(after);
        RC_ASSERT((valid ? "" : valid.error().text()) == "");
    };
    check(consolidate_leaves(d));
    RC_ASSERT(counts(consolidate_leaves(d)).cycles == before.cycles);
    check(dissolve(d, std::vector<std::int32_t>{a, b}));
    if (a != b) check(merge_nodes(d, std::vector<std::array<std::int32_t, 2>>{{a, b}}).value());
    check(merge_nodes(d, close_leaves(d, 2)).value());
    check(reroot(d, a));
    RC_ASSERT(counts(reroot(d, a)).components == before.components);
    if (!bones_of(d).empty()) check(insert_on_bone(d, 0, 0.5).value());
    for (int axis : {0, 1, 2}) {
        check(mirror(d, axis));
        check(radial_copy(d, axis, *rc::gen::inRange(1, 7)));
    }
    check(snap_to_grid(d, 2));
    check(snap_to_angle(d, 45).value());
}

}  // namespace
}  // namespace sinew
