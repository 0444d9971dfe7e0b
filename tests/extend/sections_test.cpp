#include "sinew/extend/sections.h"

#include "skinning.h"

namespace sinew {
namespace {

using namespace testing_types;

Document tube(NodeType end, double radius = 0.5) {
    Document d;
    add(d, -1, {0, 0, 0}, radius);
    add(d, 0, {0, 0, 3}, radius, end);
    return d;
}

TEST(Hemisphere, EndsInAFlatDiscOnItsCircle) {
    const Skin skin = solid(tube(NodeType::hemisphere));
    EXPECT_TRUE(has_vertex(skin.mesh, {0, 0, 3}));  // the pole, in the disc
    ASSERT_EQ(skin.mesh.features.circles.size(), 1u);
    EXPECT_FLOAT_EQ(skin.mesh.features.circles[0].radius, 0.5f);
    EXPECT_EQ(skin.mesh.features.planes.size(), 1u);
    EXPECT_EQ(skin.mesh.features.creases.size(), skin.mesh.features.circles[0].edges.size());
    expect_flat(skin.mesh, 1e-6 * 0.5);
    for (const Vec3f& p : skin.mesh.positions) EXPECT_LE(p.z(), 3 + 1e-6);
}

TEST(Hemisphere, StaysFlatAndRoundWhenSubdivided) {
    const QuadMesh fine = smooth(tube(NodeType::hemisphere));
    expect_flat(fine, 1e-6 * 0.5);
    for (const MeshEdge& edge : fine.features.circles.at(0).edges)
        EXPECT_NEAR(fine.positions[edge[0]].head<2>().norm(), 0.5, 1e-4 * 0.5);
}

TEST(Cone, HasItsTipWhereItWasPut) {
    const Skin skin = solid(tube(NodeType::cone));
    EXPECT_TRUE(has_vertex(skin.mesh, {0, 0, 3}));
    EXPECT_EQ(skin.mesh.features.corners.size(), 1u);
    EXPECT_TRUE(has_vertex(smooth(tube(NodeType::cone)), {0, 0, 3}));
}

/// Largest distance of the surface between two heights to a straight cone about z, as a share of the wide
/// end.
double off_cone(const QuadMesh& mesh, double low, double wide, double high, double narrow) {
    double worst = 0;
    for (const Vec3f& p : mesh.positions) {
        const double t = (p.z() - low) / (high - low);
        if (t > 0.1 && t < 1 && p.head<2>().norm() > 1e-6)
            worst = std::max(worst, std::abs(p.head<2>().norm() - wide - t * (narrow - wide)));
    }
    return worst / wide;
}

TEST(Cone, IsStraightWhenSubdivided) {
    Document d = tube(NodeType::sphere);
    d.nodes[0].type = NodeType::hemisphere;
    add(d, 1, {0, 0, 8}, 0.5, NodeType::cone);
    EXPECT_LT(off_cone(smooth(d), 3, 0.5, 8, 0), 0.08);
}

TEST(SphereLeaf, EndsALongTaperWithoutAKnob) {
    Document d = tube(NodeType::hemisphere);
    add(d, 1, {0, 0, 9}, 0.05).parent = 0;
    d.nodes[0].type = NodeType::cube;
    d.nodes.erase(d.nodes.begin() + 1);
    EXPECT_LT(off_cone(smooth(d), 0.5, 0.45, 9, 0.05), 0.08);
}

TEST(SphereLeaf, HasTheRingsOfItsProfile) {
    SkinOptions eight{.sides = 8};
    const Skin skin = solid(tube(NodeType::sphere), eight);
    for (const double angle : {0.0, M_PI / 4}) {  // k = 2 rings, at i pi / 2k
        const double z = 3 + 0.5 * std::sin(angle), r = 0.5 * std::cos(angle);
        int on_ring = 0;
        for (const Vec3f& p : skin.mesh.positions)
            on_ring += std::abs(p.z() - z) < 1e-6 && std::abs(p.head<2>().norm() - r) < 1e-6;
        EXPECT_EQ(on_ring, 8);
    }
    EXPECT_TRUE(has_vertex(skin.mesh, {0, 0, 3.5}));
}

Document beam(double width, double height) {
    Document d;
    for (int i = 0; i < 4; ++i) {
        Node& n =
            add(d, i - 1, {1.0 * i, 0, 0}, 0.5, i == 0 || i == 3 ? NodeType::hemisphere : NodeType::sphere);
        n.section = Section::rectangular;
        n.scale = {width, height, 1};
    }
    return d;
}

TEST(RectangularSection, IsOneStraightBeamWithoutTwistOrWaist) {
    const Document d = beam(1, 0.4);
    for (const bool subdivided : {false, true}) {
        const QuadMesh mesh = subdivided ? smooth(d, 2) : solid(d).mesh;
        Eigen::AlignedBox3f box;
        for (const Vec3f& p : mesh.positions) box.extend(p);
        EXPECT_LT((box.min() - Vec3f(0, -0.5, -0.2)).norm(), 1e-6);
        EXPECT_LT((box.max() - Vec3f(3, 0.5, 0.2)).norm(), 1e-6);
        for (int i = 0; i < 4; ++i)
            for (const double y : {-0.5, 0.5})
                for (const double z : {-0.2, 0.2}) EXPECT_TRUE(has_vertex(mesh, {1.0 * i, y, z}));
        // Four lines of creases along: corner k joins corner k.
        for (const Crease& crease : mesh.features.creases) {
            const Vec3f along = mesh.positions[crease.edge[1]] - mesh.positions[crease.edge[0]];
            if (std::abs(along.x()) > 1e-6) {
                EXPECT_LT(along.tail<2>().norm(), 1e-6);
            }
        }
    }
}

TEST(RectangularSection, ComesEvenlyOutOfTheCircle) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.5, NodeType::hemisphere);
    add(d, 0, {0, 0, 1}, 0.5);
    Node& end = add(d, 1, {0, 0, 2}, 0.5, NodeType::hemisphere);
    end.section = Section::rectangular;
    const Skin skin = solid(d);
    for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5}) EXPECT_TRUE(has_vertex(skin.mesh, {x, y, 2}));
    const double diagonal = 0.5 * std::sqrt(0.5);
    EXPECT_TRUE(
        has_vertex(skin.mesh, {diagonal, diagonal, 0}));  // the circle's vertices stand below the corners
}

TEST(Scale, MakesAnEllipseOfTheSection) {
    Document d = tube(NodeType::hemisphere);
    for (Node& n : d.nodes) n.type = NodeType::hemisphere, n.scale = {2, 0.5, 1};
    const Skin skin = solid(d, {.sides = 12});
    for (const Vec3f& p : skin.mesh.positions) {
        if (p.head<2>().norm() < 1e-6) continue;  // poles
        EXPECT_NEAR(std::hypot(p.x() / 1.0, p.y() / 0.25), 1, 1e-5);
    }
}

TEST(SharpJoint, CreasesItsRing) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.2);
    add(d, 0, {0, 0, 2}, 0.2).joint = infinitely_sharp;
    add(d, 1, {2, 0, 2}, 0.2);
    const Skin skin = solid(d);
    EXPECT_EQ(skin.mesh.features.creases.size(), 4u);
    for (const Crease& crease : skin.mesh.features.creases) EXPECT_GE(crease.sharpness, 10);
}

TEST(SharpJoint, AtABranchCreasesItsArcs) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.2).joint = 2;
    for (const Vec3& at : {Vec3(2, 0, 0), Vec3(-1, 2, 0), Vec3(-1, -2, 0)}) add(d, 0, at, 0.2);
    const Skin skin = solid(d);
    EXPECT_EQ(skin.mesh.features.creases.size(), 6u);  // three arcs of two pieces
    for (const Crease& crease : skin.mesh.features.creases) EXPECT_FLOAT_EQ(crease.sharpness, 2);
}

}  // namespace
}  // namespace sinew
