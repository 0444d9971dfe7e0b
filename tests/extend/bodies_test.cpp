#include "sinew/extend/bodies.h"
#include "sinew/mesh/intersect.h"
#include "sinew/mesh/measure.h"

#include "skinning.h"

namespace sinew {
namespace {

using namespace testing_types;

void expect_box(const QuadMesh& mesh, const std::vector<Vec3>& corners, std::size_t creases_at_least = 12) {
    for (const Vec3& corner : corners) EXPECT_TRUE(has_vertex(mesh, corner)) << corner.transpose();
    EXPECT_GE(mesh.features.planes.size(), 6u);
    EXPECT_GE(mesh.features.creases.size(), creases_at_least);
    expect_flat(mesh, 1e-6);
}

TEST(Cube, AloneIsABox) {
    Document d;
    add(d, -1, {1, 2, 3}, 0.5, NodeType::cube).size = Vec3(1, 2, 3);
    const Skin skin = solid(d);
    expect_box(skin.mesh, box_corners({1, 2, 3}, Mat3::Identity(), {0.5, 1, 1.5}), 24);
    EXPECT_EQ(skin.mesh.features.corners.size(), 8u);
    EXPECT_EQ(irregular(skin.mesh), 8);
}

TEST(Cube, AtALeafStandsAlongItsBone) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.2);
    add(d, 0, {3, 0, 0}, 0.2, NodeType::cube).size = Vec3(1, 0.8, 0.6);
    Mat3 axes;  // z along the bone, x the world's Y
    axes << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    const Skin skin = solid(d);
    expect_box(skin.mesh, box_corners({3, 0, 0}, axes, {0.5, 0.4, 0.3}));
    EXPECT_EQ(skin.mesh.features.corners.size(), 8u);
    EXPECT_TRUE(has_vertex(skin.mesh, {3.3, 0, 0}));  // the pole in the middle of the top
}

TEST(Cube, AtALeafRollsAboutItsBone) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.2);
    Node& cube = add(d, 0, {0, 0, 3}, 0.2, NodeType::cube);
    cube.roll = 45;
    const double half = 0.2 * std::sqrt(2.0);
    const Skin skin = solid(d);
    for (const Vec3& at : {Vec3(half, 0, 3.2), Vec3(0, half, 2.8), Vec3(-half, 0, 3.2)})
        EXPECT_TRUE(has_vertex(skin.mesh, at));
}

TEST(Cube, BetweenTwoTubesIsJoinedToBothAtRightAngles) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.2);
    add(d, 0, {0, 0, 2}, 0.2, NodeType::cube).size = Vec3(1, 1, 1);
    add(d, 1, {0, 0, 4}, 0.2);
    const Skin skin = solid(d);
    expect_box(skin.mesh, box_corners({0, 0, 2}, Mat3::Identity(), {0.5, 0.5, 0.5}));
    EXPECT_LE(irregular(skin.mesh), 2);  // all rings: only the poles may be irregular
    for (const Circle& circle : skin.mesh.features.circles) {
        EXPECT_NEAR(std::abs(circle.axis.z()), 1, 1e-6);
        EXPECT_NEAR(std::abs(circle.centre.z() - 2), 0.5, 1e-6);
        EXPECT_NEAR(circle.radius, 0.2, 1e-6);
    }
    EXPECT_EQ(skin.mesh.features.circles.size(), 2u);
}

TEST(Cube, AtABranchHasAllCornersAndSquareTubes) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.3, NodeType::cube).size = Vec3(1, 1.2, 1.4);
    for (const Vec3& at : {Vec3(2, 0, 0), Vec3(-2, 0.1, 0), Vec3(0, 0, 2)}) add(d, 0, at, 0.3);
    const Skin skin = solid(d);
    expect_box(skin.mesh, box_corners({0, 0, 0}, Mat3::Identity(), {0.5, 0.6, 0.7}));
    EXPECT_EQ(skin.mesh.features.circles.size(), 3u);
    for (const Circle& circle : skin.mesh.features.circles)
        EXPECT_NEAR(circle.axis.cwiseAbs().maxCoeff(), 1, 1e-6);
    EXPECT_LE(irregular(skin.mesh), skin.irregular);
    const QuadMesh fine = smooth(d, 2);
    for (const Vec3& corner : box_corners({0, 0, 0}, Mat3::Identity(), {0.5, 0.6, 0.7}))
        EXPECT_TRUE(has_vertex(fine, corner));
    expect_flat(fine, 1e-6);
}

TEST(Cube, LetsABeamAsLargeAsItsFaceGoOnFlush) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.1, NodeType::cube).size = Vec3(1, 0.6, 0.4);
    Node& beam = add(d, 0, {0, 0, 2}, 0.3, NodeType::hemisphere);
    beam.section = Section::rectangular;
    beam.scale = {5.0 / 3, 1, 1};
    const Skin skin = solid(d);
    for (const Vec3f& p : skin.mesh.positions)
        EXPECT_GE(std::max(std::abs(p.x()) / 0.5, std::abs(p.y()) / 0.3), -1e-6);
    EXPECT_TRUE(skin.mesh.features.circles.empty());  // no round tube, no shoulder
    for (const double x : {-0.5, 0.5}) EXPECT_TRUE(has_vertex(skin.mesh, {x, 0.3, 2}));
    d.nodes[1].type = NodeType::sphere;
    add(d, 1, {0, 0, 4}, 0.2);  // the same where the beam goes on
    EXPECT_TRUE(solid(d).mesh.features.circles.empty());
}

TEST(Cube, HasRoomForATubeNearlyAsWideAsItsFace) {
    for (const double radius : {0.2, 0.3, 0.4, 0.44, 0.5, 2.0})
        for (const NodeType root : {NodeType::cube, NodeType::sphere}) {
            Document d;
            add(d, -1, {0, 0, 0}, radius, root).size = Vec3(1, 2, 3);
            add(d, 0, {0, 0, 4}, radius, NodeType::cube).size = Vec3(1, 2, 3);
            for (int levels = 1; levels <= 3; ++levels) {
                const QuadMesh fine = smooth(d, levels);
                for (const Plane& plane : fine.features.planes)  // every face lies the right way round
                    for (const std::uint32_t f : plane.faces) {
                        const auto face = fine.face(f);
                        const Vec3f a = fine.positions[face[1]] - fine.positions[face[0]],
                                    b = fine.positions[face[2]] - fine.positions[face[0]];
                        EXPECT_GT(a.cross(b).dot(plane.normal), 0) << radius;
                    }
            }
        }
}

TEST(Cube, PartsAllItsEdgesAlike) {
    Document d;  // the wide tube wants more vertices than four
    add(d, -1, {0, 0, 0}, 0.5, NodeType::cube).size = Vec3(1, 2, 3);
    add(d, 0, {0, 0, 4}, 0.5);
    const Skin skin = solid(d);
    for (const double x : {-0.5, -0.5 / 3, 0.5 / 3, 0.5})
        for (const double y : {-1.0, 1.0})
            for (const double z : {-1.5, 1.5}) EXPECT_TRUE(has_vertex(skin.mesh, {x, y, z}));
    EXPECT_EQ(skin.mesh.features.circles.at(0).edges.size(), 12u);
}

TEST(Cube, WithSeveralBonesThroughOneFaceIsClosed) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.3, NodeType::cube);
    for (const double x : {-1.0, 0.0, 1.0}) add(d, 0, {x, 0.3 * x * x, 4}, 0.1);
    solid(d);
}

double roundness(const QuadMesh& mesh, const Vec3& half, double below) {
    return farthest_from_ball(mesh, Vec3::Zero(), half, [&](const Vec3& v) {
        return v.norm() <= 1.3 * half.maxCoeff() && v.z() >= below;
    });
}

TEST(Ball, AloneIsRoundWithinOnePercent) {
    Document d;
    add(d, -1, {0, 0, 0}, 1, NodeType::ball);
    EXPECT_LT(roundness(smooth(d), Vec3::Ones(), -2), 0.01);
}

TEST(Ball, OnAStickIsRoundWithinOnePercent) {
    Document d;
    add(d, -1, {0, 0, 0}, 1, NodeType::ball);
    add(d, 0, {0, 0, -4}, 0.15, NodeType::hemisphere);
    EXPECT_LT(roundness(smooth(d), Vec3::Ones(), -0.98), 0.01);
}

TEST(Ball, WithFiveLimbsLiesOnTheSphere) {
    Document d;
    add(d, -1, {0, 0, 0}, 1, NodeType::ball);
    for (int i = 0; i < 5; ++i) {
        const double a = 2 * M_PI * i / 5;
        add(d, 0, 4 * Vec3(std::cos(a), std::sin(a), 0.3).normalized(), 0.15);
    }
    const QuadMesh mesh = smooth(d);
    double worst = 0;
    for (const Vec3f& p : mesh.positions) {
        const Vec3 v = p.cast<double>();
        bool at_limb = v.norm() > 1.4;
        for (int i = 1; i <= 5; ++i) {
            const Vec3 axis = d.nodes[i].position.normalized();
            at_limb = at_limb || (v.dot(axis) > 0 && v.cross(axis).norm() < 0.25);
        }
        if (!at_limb) worst = std::max(worst, std::abs(v.norm() - 1));
    }
    EXPECT_LT(worst, 0.01);
}

TEST(Ball, ScaledIsAnEllipsoid) {
    Document d;
    add(d, -1, {0, 0, 0}, 1, NodeType::ball).scale = {0.75, 0.9, 1};
    EXPECT_LT(roundness(smooth(d), {0.75, 0.9, 1}, -2), 0.01);
}

TEST(Ball, SharpCreasesTheCircleOfItsTube) {
    Document d;
    Node& ball = add(d, -1, {0, 0, 0}, 1, NodeType::ball);
    ball.joint = infinitely_sharp;
    add(d, 0, {0, 0, -4}, 0.15);
    const Skin skin = solid(d);
    ASSERT_EQ(skin.mesh.features.circles.size(), 1u);
    EXPECT_EQ(skin.mesh.features.creases.size(), skin.mesh.features.circles[0].edges.size());
    EXPECT_NEAR(skin.mesh.features.circles[0].centre.z(), -std::sqrt(1 - 0.15 * 0.15), 1e-6);
}

Document pitted(double outside, double radius) {
    Document d;
    add(d, -1, {0, 0, 0}, 1, NodeType::ball);
    add(d, 0, {0, 0, 1 + outside}, radius, NodeType::negative);
    return d;
}

TEST(Negative, IsAsDeepAsItStandsOutsideAndAsWideAsItsRadius) {
    const QuadMesh mesh = smooth(pitted(0.4, 0.3));
    double bottom = 1;
    for (const Vec3f& p : mesh.positions)
        if (p.z() > 0 && p.head<2>().norm() < 0.02) bottom = std::min<double>(bottom, p.z());
    EXPECT_NEAR(1 - bottom, 0.4, 0.05 * 0.4);
    const Skin skin = solid(pitted(0.4, 0.3));  // the rim lies on the ball, at the radius
    int rim = 0;
    for (const Vec3f& p : skin.mesh.positions)
        rim += p.z() > 0 && std::abs(p.norm() - 1) < 1e-4 && std::abs(p.head<2>().norm() - 0.3) < 0.05 * 0.3;
    EXPECT_GE(rim, 4);
}

TEST(Negative, DeeperThanItsParentIsClampedWithAWarning) {
    const Skin skin = solid(pitted(5, 0.3));
    ASSERT_EQ(skin.warnings.size(), 1u);
    EXPECT_THAT(skin.warnings[0].message, ::testing::HasSubstr("node 1"));
    for (const Vec3f& p : skin.mesh.positions) EXPECT_LE(p.norm(), 1 + 1e-5);
}

/// A cube, a ball and the middle of a limb, all reaching up to 1 from a node 0; the dent is drawn much
/// deeper.
TEST(Negative, DeeperThanAnyParentEndsBeforeItsFarSide) {
    for (const NodeType type : {NodeType::cube, NodeType::ball, NodeType::sphere}) {
        Document d;
        add(d, -1, {0, 0, 0}, 1, type);
        add(d, 0, {0, 0, 4}, 0.3, NodeType::negative);
        if (type == NodeType::sphere) add(d, 0, {4, 0, 0}, 1), add(d, 0, {-4, 0, 0}, 1);
        const Skin skin = solid(d);
        ASSERT_EQ(skin.warnings.size(), 1u);
        EXPECT_THAT(skin.warnings[0].message, ::testing::HasSubstr("node 1"));
        double bottom = 1;
        for (const Vec3f& p : skin.mesh.positions)
            if (p.head<2>().norm() < 1e-3 && p.z() > -0.99f) bottom = std::min<double>(bottom, p.z());
        EXPECT_LT(bottom, 0);  // beyond the middle
        EXPECT_GT(measure(skin.mesh).volume, 0);
    }
}

TEST(Negative, NeighboursThatOverlapMergeIntoOneGroove) {
    Document d;
    add(d, -1, {0, 0, 0}, 1, NodeType::ball);
    for (const double a : {-0.25, 0.0, 0.25})
        add(d, 0, 1.2 * Vec3(std::sin(a), 0, std::cos(a)), 0.25, NodeType::negative);
    const QuadMesh mesh = smooth(d);
    for (const Vec3f& p : mesh.positions) {
        if (p.z() < 0) continue;
        const double across = std::abs(p.y()), depth = 1 - p.norm();
        const bool between = std::abs(p.x()) < 0.22;
        if (between && across < 0.02) {
            EXPECT_NEAR(depth, 0.2, 0.05 * 0.2);  // one floor, without a ridge
        }
        if (between && across < 0.16) {
            EXPECT_GT(depth, 0.1);  // as wide between the dents as in them
        }
        if (across > 0.36) {
            EXPECT_NEAR(depth, 0, 0.02);
        }
    }
    EXPECT_EQ(measure(mesh).folded_quads.count, 0u);
}

TEST(Negative, AtTheEndOfALimbMakesABowl) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.3);
    add(d, 0, {0, 0, 2}, 1);
    add(d, 1, {0, 0, 3.5}, 0.8, NodeType::negative);
    const Skin skin = solid(d);
    EXPECT_LT(distance_to(skin.mesh, {0, 0, 2.5}), 1e-5);  // half a unit below the top
}

TEST(Negative, FoldsNothingHoweverWideTheBowl) {
    for (const double radius : {0.2, 0.4, 0.6, 0.7, 0.8, 0.85}) {
        SCOPED_TRACE(radius);
        Document d;
        add(d, -1, {0, 0, 0}, 0.8, NodeType::hemisphere);
        add(d, 0, {0, 0, 2.5}, 1);
        add(d, 1, {0, 0, 4}, radius, NodeType::negative);
        for (const QuadMesh& mesh : {solid(d).mesh, smooth(d)}) {
            EXPECT_EQ(measure(mesh).folded_quads.count, 0u);
            EXPECT_TRUE(find_self_intersections(mesh)->empty());
        }
    }
}

TEST(Bodies, WorkAtDistanceZero) {
    for (const NodeType type :
         {NodeType::cube, NodeType::hemisphere, NodeType::cone, NodeType::ball, NodeType::negative}) {
        Document d;
        add(d, -1, {0, 0, 0}, 0.5);
        add(d, 0, {0, 0, 2}, 0.5);
        add(d, 1, {0, 0, 2}, 0.4, type);
        solid(d);
    }
}

}  // namespace
}  // namespace sinew
