#include "sinew/skeleton/symmetry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sinew/skeleton/frames.h"
#include "sinew/skeleton/graph.h"
#include "sinew/skeleton/validate.h"

namespace sinew {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

Symmetry mirror(int axis) { return {Symmetry::Kind::mirror, axis, 1}; }
Symmetry radial(int axis, int count) { return {Symmetry::Kind::radial, axis, count}; }

Document with(const Symmetry& symmetry, std::initializer_list<Node> nodes) {
    Document document{.symmetry = symmetry, .nodes = nodes};
    for (std::size_t i = 0; i < document.nodes.size(); ++i)
        document.nodes[i].id = 10 + static_cast<std::int64_t>(i);
    return document;
}

Mat3 frame_of(const Document& document, std::int32_t node) {
    const std::vector<Bone> bones = bones_of(document);
    return local_frame(document, bones, adjacency(static_cast<std::int32_t>(document.nodes.size()), bones),
                       node);
}

/// The expansion is valid, bones go along with their nodes, and the generator does what it says.
void expect_symmetric(const ExpandedSymmetry& all, const Symmetry& symmetry) {
    EXPECT_TRUE(validate(all.document)) << validate(all.document).error().text();
    EXPECT_EQ(all.document.symmetry.kind, Symmetry::Kind::none);
    auto undirected = [](std::vector<Bone> bones) {
        for (Bone& bone : bones) std::ranges::sort(bone);
        std::ranges::sort(bones);
        return bones;
    };
    std::vector<Bone> bones = bones_of(all.document), images;
    for (const auto& [a, b] : bones) images.push_back({all.image[a], all.image[b]});
    EXPECT_EQ(undirected(images), undirected(bones));
    for (std::size_t i = 0; i < all.image.size(); ++i) {
        const Node &node = all.document.nodes[i], &image = all.document.nodes[all.image[i]],
                   &source = all.document.nodes[all.source[i]];
        EXPECT_EQ(node.position, symmetry_transform(symmetry, all.power[i]) * source.position);
        EXPECT_TRUE((all.generator * node.position - image.position).norm() <=
                    1e-14 * (1 + node.position.norm()));
        EXPECT_EQ(image.radius, node.radius);
        EXPECT_EQ(image.type, node.type);
        std::int32_t there = static_cast<std::int32_t>(i);
        for (int k = 0; k < all.order; ++k) there = all.image[there];
        EXPECT_EQ(there, static_cast<std::int32_t>(i));
    }
}

TEST(SymmetryTransform, TurnsAreExactAndMirrorOneAnother) {
    const double half = std::numbers::sqrt2 / 2;
    EXPECT_EQ(symmetry_transform(radial(2, 8), 1) * Vec3(1, 0, 5), Vec3(half, half, 5));
    EXPECT_EQ(symmetry_transform(radial(2, 4), 1) * Vec3(1, 2, 5), Vec3(-2, 1, 5));
    EXPECT_EQ(symmetry_transform(radial(0, 2), 1) * Vec3(7, 1, 2), Vec3(7, -1, -2));
    EXPECT_EQ(symmetry_transform(mirror(1), 1) * Vec3(1, 2, 3), Vec3(1, -2, 3));
    for (int count : {3, 5, 7, 12, 360, 997})
        for (int k = 1; k < count; ++k) {
            const Mat3 turn = symmetry_transform(radial(2, count), k),
                       back = symmetry_transform(radial(2, count), count - k);
            EXPECT_EQ(turn, Mat3(back.transpose()));
            EXPECT_NEAR(turn(0, 0), std::cos(2 * std::numbers::pi * k / count),
                        2e-15);  // what rounding the angle costs the reference
            EXPECT_NEAR(turn(1, 0), std::sin(2 * std::numbers::pi * k / count), 2e-15);
        }
}

TEST(ExpandSymmetry, WithoutSymmetryNothingChanges) {
    const ExpandedSymmetry all = expand_symmetry(with({}, {{.position = {1, 0, 0}}}));
    EXPECT_THAT(all.document.nodes, SizeIs(1));
    EXPECT_EQ(all.order, 1);
    EXPECT_THAT(all.image, ElementsAre(0));
}

TEST(ExpandSymmetry, NodesOnThePlaneAreTheirOwnImages) {
    // A spine of two, the upper one a bit off the plane, and an arm.
    const Symmetry symmetry = mirror(0);
    const ExpandedSymmetry all = expand_symmetry(with(symmetry, {{.position = {0, 0, 0}},
                                                                 {.parent = 0, .position = {1e-7, 0, 5}},
                                                                 {.parent = 1, .position = {3, 0, 5}}}));
    expect_symmetric(all, symmetry);
    ASSERT_THAT(all.document.nodes, SizeIs(4));
    EXPECT_THAT(all.image, ElementsAre(0, 1, 3, 2));
    EXPECT_EQ(all.document.nodes[1].position, Vec3(0, 0, 5));
    EXPECT_EQ(all.document.nodes[3].position, Vec3(-3, 0, 5));
    EXPECT_EQ(all.document.nodes[3].parent, 1);
    EXPECT_EQ(all.document.nodes[3].id, 13);
    EXPECT_THAT(all.document.links, SizeIs(0));
}

TEST(ExpandSymmetry, ABoneThroughThePlaneClosesACycle) {
    // A rung whose middle is on the plane hangs at a rail that is not.
    const Symmetry symmetry = mirror(0);
    const ExpandedSymmetry all = expand_symmetry(with(symmetry, {{.position = {2, 0, 0}},
                                                                 {.parent = 0, .position = {2, 0, 5}},
                                                                 {.parent = 0, .position = {0, 0, 0}},
                                                                 {.parent = 1, .position = {0, 0, 5}}}));
    expect_symmetric(all, symmetry);
    const GraphCounts counts = count_graph(6, bones_of(all.document));
    EXPECT_EQ(counts.components, 1);
    EXPECT_EQ(counts.cycles, 1);
}

TEST(ExpandSymmetry, AStepOfARingClosesIt) {
    const double half = 0.70711;  // as typed
    const Symmetry symmetry = radial(2, 8);
    Document drawn = with(symmetry, {{.position = {0, 0, 0}},
                                     {.parent = 0, .position = {1, 0, 0}},
                                     {.parent = 1, .position = {half, half, 0}}});
    const ExpandedSymmetry all = expand_symmetry(drawn);
    expect_symmetric(all, symmetry);
    ASSERT_THAT(all.document.nodes, SizeIs(9));
    EXPECT_EQ(all.source[2], 1);
    EXPECT_EQ(all.power[2], 1);
    EXPECT_EQ(all.document.nodes[2].position, Vec3(std::numbers::sqrt2 / 2, std::numbers::sqrt2 / 2, 0));
    EXPECT_EQ(all.document.nodes[2].id, 12);
    EXPECT_THAT(bones_of(all.document), SizeIs(16));  // eight spokes, eight steps
    EXPECT_EQ(count_graph(9, bones_of(all.document)).cycles, 8);
}

TEST(ExpandSymmetry, CoincidentNodesStayTwo) {
    const Symmetry symmetry = mirror(1);
    const ExpandedSymmetry all = expand_symmetry(with(symmetry, {{.position = {0, 1, 0}},
                                                                 {.parent = 0, .position = {0, 1, 0}},
                                                                 {.parent = 1, .position = {0, -1, 0}}}));
    expect_symmetric(all, symmetry);
    EXPECT_THAT(all.document.nodes, SizeIs(4));
}

TEST(ExpandSymmetry, TipsThatMeetOnThePlaneAreNoTips) {
    const ExpandedSymmetry all = expand_symmetry(with(
        mirror(0), {{.position = {2, 0, 0}}, {.parent = 0, .position = {0, 0, 0}, .type = NodeType::cone}}));
    expect_symmetric(all, mirror(0));
    EXPECT_EQ(all.document.nodes[1].type, NodeType::sphere);
}

/// Every box stands as the transformed box of its source does: the axes agree up to their signs.
TEST(ExpandSymmetry, BoxesTurnWithTheirNodes) {
    for (const Symmetry& symmetry :
         {mirror(0), mirror(1), mirror(2), radial(0, 5), radial(1, 4), radial(2, 7)}) {
        Document drawn = with(
            symmetry, {{.position = {0.5, 0.7, 1}, .type = NodeType::cube, .roll = 20},
                       {.parent = 0, .position = {2, 3, 4}, .type = NodeType::cube, .roll = 33},
                       {.parent = 1, .position = {6, 3, 4.5}, .section = Section::rectangular, .roll = -12},
                       {.parent = 1, .position = {2, 3, 9}, .type = NodeType::cube},
                       {.parent = 1, .position = {2, 9, 9}, .type = NodeType::cube, .roll = 5}});
        drawn.nodes[0].rotation = Quat(0.5, 0.5, -0.5, 0.5);
        const ExpandedSymmetry all = expand_symmetry(drawn);
        expect_symmetric(all, symmetry);
        for (std::int32_t i = 0; i < std::ssize(all.document.nodes); ++i) {
            const Mat3 wanted =
                symmetry_transform(symmetry, all.power[i]) * frame_of(all.document, all.source[i]);
            const Mat3 turn = (frame_of(all.document, i).transpose() * wanted).cwiseAbs();
            EXPECT_TRUE(turn.isIdentity(1e-9)) << "axis " << symmetry.axis << " node " << i << '\n' << turn;
        }
    }
}

TEST(ExpandSymmetry, SectionsOfRootsTurnWithTheirNodes) {
    for (const Symmetry& symmetry : {mirror(0), mirror(2), radial(0, 5), radial(1, 4), radial(2, 7)}) {
        const Document drawn =
            with(symmetry,
                 {{.position = {1, 2, 3}, .section = Section::rectangular, .scale = {1, 0.5, 1}, .roll = 20},
                  {.parent = 0, .position = {2, 5, 4}}});
        const ExpandedSymmetry all = expand_symmetry(drawn);
        for (std::int32_t i = 0; i < std::ssize(all.document.nodes); ++i) {
            if (all.source[i] != 0) continue;
            const Mat3 wanted = symmetry_transform(symmetry, all.power[i]) * frame_of(all.document, 0);
            const Mat3 turn = (frame_of(all.document, i).transpose() * wanted).cwiseAbs();
            EXPECT_TRUE(turn.isIdentity(1e-9)) << "axis " << symmetry.axis << " node " << i << '\n' << turn;
        }
    }
}

TEST(ExpandSymmetry, MirroredRollsChangeTheirSignExactly) {
    Document drawn =
        with(mirror(0), {{.position = {1, 0, 0}},
                         {.parent = 0, .position = {2, 1, 3}, .type = NodeType::cube, .roll = 33.3}});
    EXPECT_EQ(expand_symmetry(drawn).document.nodes[3].roll, -33.3);
}

}  // namespace
}  // namespace sinew
