#include <gtest/gtest.h>

#include "sinew/extend/extend.h"

namespace sinew {
namespace {

Document pair_of_limbs() {
    Document d;
    const auto add = [&](std::int32_t parent, const Vec3& position) {
        Node node;
        node.id = std::ssize(d.nodes);
        node.parent = parent;
        node.position = position;
        node.radius = 0.3;
        d.nodes.push_back(node);
    };
    add(-1, {0, 0, 0});
    add(0, {0, 3, 1});
    add(0, {2, 1, 0.5});
    add(0, {-2, 1, 0.5});
    return d;
}
Automorphism mirror_of(const Document& document) {
    Warnings warnings;
    return find_mirror(extend(document, condition(document), warnings));
}

TEST(FindMirror, FindsThePlaneAndTheImages) {
    const Automorphism mirror = mirror_of(pair_of_limbs());
    ASSERT_EQ(mirror.order, 2);
    EXPECT_TRUE(mirror.generator.isApprox(Mat3(Vec3(-1, 1, 1).asDiagonal())));
    EXPECT_EQ(mirror.image, (std::vector<std::int32_t>{0, 1, 3, 2}));
}

TEST(FindMirror, IsExact) {
    Document d = pair_of_limbs();
    d.nodes[3].position.x() = -2 * (1 + 1e-15);
    EXPECT_EQ(mirror_of(d).order, 1);
    d = pair_of_limbs();
    d.nodes[3].radius = 0.31;
    EXPECT_EQ(mirror_of(d).order, 1);
}

TEST(FindMirror, ComparesTypesAndBones) {
    Document d = pair_of_limbs();
    d.nodes[3].type = NodeType::hemisphere;
    EXPECT_EQ(mirror_of(d).order, 1);
    d.nodes[2].type = NodeType::hemisphere;
    EXPECT_EQ(mirror_of(d).order, 2);
    d = pair_of_limbs();
    d.nodes[3].parent = 1;
    EXPECT_EQ(mirror_of(d).order, 1);
}

TEST(FindMirror, ComparesOutlines) {
    const auto order_with = [](const auto& dress) {
        Document d = pair_of_limbs();
        for (Node* node : {&d.nodes[2], &d.nodes[3]}) node->joint = 1, node->scale = {2, 1, 1};
        dress(d.nodes[2]);
        return mirror_of(d).order;
    };
    EXPECT_EQ(order_with([](Node&) {}), 2);
    EXPECT_EQ(order_with([](Node& node) { node.section = Section::rectangular; }), 1);
    EXPECT_EQ(order_with([](Node& node) { node.joint = 2; }), 1);
    EXPECT_EQ(order_with([](Node& node) { node.joint = 0, node.scale = {1, 1, 1}; }), 1) << "has none";
    EXPECT_EQ(order_with([](Node& node) { node.scale = {1, 2, 1}; }), 1);
    EXPECT_EQ(order_with([](Node& node) { node.scale = {2, 1.001, 1}; }), 1);
    EXPECT_EQ(order_with([](Node& node) { node.roll = 30; }), 1);
    EXPECT_EQ(order_with([](Node& node) { node.roll = 180; }), 2) << "the same ellipse";
    EXPECT_EQ(order_with([](Node& node) { node.roll = 90, node.scale = {1, 2, 1}; }), 2) << "the same across";
}

TEST(FindMirror, TakesThePlaneOfAFlatSkeletonWhereNoOtherFits) {
    Document d = pair_of_limbs();
    for (Node& node : d.nodes) node.position.z() = 0;
    EXPECT_LT(mirror_of(d).generator(0, 0), 0);  // something lies beside this one
    d.nodes[3].position = {-1, -2, 0};
    EXPECT_LT(mirror_of(d).generator(2, 2), 0);
}

}  // namespace
}  // namespace sinew
