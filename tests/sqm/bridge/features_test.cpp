#include "sinew/sqm/bridge/features.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "sinew/mesh/topology.h"
#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

/// Placed, with its features.
QuadMesh finished(const Document& document, int sides = 0) {
    const Stages s(document, sides);
    Bridge b = bridge(s.parts()).value();
    finish(s, false, b);
    const Topology topology = build_topology(b.mesh);
    for (const Crease& crease : b.mesh.features.creases) {
        EXPECT_NE(find_edge(topology, crease.edge), no_index);
        EXPECT_GT(crease.sharpness, 0);
    }
    return b.mesh;
}

TEST(Features, OfBallsAndRoundBonesArePolesOnly) {
    const Features f = finished(star(fan(5))).features;
    EXPECT_TRUE(f.creases.empty() && f.corners.empty() && f.circles.empty() && f.planes.empty());
    EXPECT_EQ(f.poles.size(), 5u);
}

TEST(Features, OfAFlatEndAreItsRimAndItsDisc) {
    Document d = star(fan(3), 4, 0.5);
    d.nodes[1].type = NodeType::hemisphere;
    const QuadMesh mesh = finished(d, 8);
    const Features& f = mesh.features;
    ASSERT_EQ(f.circles.size(), 1u);
    EXPECT_EQ(f.circles[0].edges.size(), 8u);
    EXPECT_EQ(f.creases.size(), 8u);
    EXPECT_NEAR(f.circles[0].radius, 0.5, 1e-6);
    EXPECT_NEAR(std::abs(f.circles[0].axis.x()), 1, 1e-6);
    ASSERT_EQ(f.planes.size(), 1u);
    EXPECT_EQ(f.planes[0].faces.size(), 8u);
    for (const std::uint32_t face : f.planes[0].faces)
        for (const std::uint32_t v : mesh.face(face))
            EXPECT_NEAR((mesh.positions[v] - f.planes[0].point).dot(f.planes[0].normal), 0, 1e-5);
}

TEST(Features, OfATipAreItsCorner) {
    Document d = star(fan(3), 4, 0.5);
    d.nodes[2].type = NodeType::cone;
    const QuadMesh mesh = finished(d);
    ASSERT_EQ(mesh.features.corners.size(), 1u);
    EXPECT_TRUE(mesh.positions[mesh.features.corners[0]].isApprox(d.nodes[2].position.cast<float>(), 1e-5f));
}

TEST(Features, OfABoxAreItsEdgesCornersAndSides) {
    Document d;
    add(d, -1, {1, 2, 3}, 1);
    d.nodes[0].type = NodeType::cube;
    d.nodes[0].size = Vec3(1, 2, 3);
    const QuadMesh mesh = finished(d);
    const Features& f = mesh.features;
    EXPECT_EQ(f.corners.size(), 8u);
    EXPECT_EQ(f.creases.size(), 24u);  // twelve edges, in two pieces each
    EXPECT_EQ(f.planes.size(), 6u);
    std::set<std::uint32_t> covered;
    for (const Plane& plane : f.planes) covered.insert(plane.faces.begin(), plane.faces.end());
    EXPECT_EQ(covered.size(), mesh.face_count());
}

/// A box of three thin tubes, or of a beam as wide as its face and two tubes: a plane for every side that is
/// seen, and creases that go on along the beam.
TEST(Features, OfABoxThatIsAJointAreItsSidesAndTheEdgesOfFlushBeams) {
    for (const bool flush : {false, true}) {
        Document d = star(std::vector<Vec3>{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, 5, 0.2);
        d.nodes[0].type = NodeType::cube;
        d.nodes[0].size = Vec3(2, 2, 2);
        if (flush) {
            d.nodes[1].section = Section::rectangular;
            d.nodes[1].radius = 1;
        }
        const QuadMesh mesh = finished(d);
        const Features& f = mesh.features;
        std::set<std::array<int, 3>> sides;
        for (const Plane& plane : f.planes)
            if (std::abs(plane.point.dot(plane.normal) - 1) < 1e-5f && !plane.faces.empty())
                sides.insert({int(std::lround(plane.normal.x())), int(std::lround(plane.normal.y())),
                              int(std::lround(plane.normal.z()))});
        EXPECT_EQ(sides.count({1, 0, 0}), flush ? 0u : 1u);
        EXPECT_EQ(sides.size(), flush ? 5u : 6u);
        std::set<std::array<int, 2>> beam;  // edges along x, by their y and z
        for (const Crease& crease : f.creases) {
            const Vec3f &a = mesh.positions[crease.edge[0]], &b = mesh.positions[crease.edge[1]];
            const bool from_box = std::abs(std::min(a.x(), b.x()) - 1) < 1e-5f;
            if (from_box && std::max(a.x(), b.x()) > 1.5f)
                beam.insert({int(std::lround(a.y())), int(std::lround(a.z()))});
        }
        EXPECT_EQ(beam.size(), flush ? 4u : 0u);
    }
}

/// A beam that gets thinner and wider again in steps, and a tube that stands on a box.
TEST(Features, PlanesLookOutOfTheSolid) {
    Document steps;
    for (int i = 0; i < 3; ++i) {
        Node& node = steps.nodes[add(steps, i - 1, {2.0 * i, 0, 0}, 0.5)];
        node.type = NodeType::cube;
        node.size = i == 1 ? Vec3(2, 1, 1) : Vec3(2, 2, 2);
    }
    Document post;
    add(post, -1, {0, 0, 0}, 0.3);
    post.nodes[0].type = NodeType::cube;
    post.nodes[0].size = Vec3(2, 2, 2);
    add(post, 0, {0, 0, 5}, 0.3);
    int plates = 0;
    for (const Document& d : {steps, post}) {
        const Stages s(d);
        for (const Station& ring : s.stations.stations) plates += ring.to_next == BoneKind::plate;
        const QuadMesh mesh = finished(d);
        EXPECT_FALSE(mesh.features.planes.empty());
        for (const Plane& plane : mesh.features.planes)
            for (const std::uint32_t f : plane.faces) {
                const auto face = mesh.face(f);
                Vec3f area = Vec3f::Zero();
                for (std::size_t k = 0; k < face.size(); ++k)
                    area += mesh.positions[face[k]].cross(mesh.positions[face[(k + 1) % face.size()]]);
                EXPECT_NEAR(area.normalized().dot(plane.normal), 1, 1e-4);
            }
    }
    EXPECT_GT(plates, 1);
}

TEST(Features, OfASharpJointAreTheEdgesOfItsRing) {
    Document d = chain(std::vector<Vec3>{{0, 0, 0}, {4, 0, 0}, {8, 1, 0}}, 0.5);
    d.nodes[1].joint = 3;
    const Features f = finished(d).features;
    EXPECT_EQ(f.creases.size(), 4u);
    for (const Crease& crease : f.creases) EXPECT_EQ(crease.sharpness, 3);
}

}  // namespace
}  // namespace sinew::sqm
