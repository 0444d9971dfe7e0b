#include "sinew/mesh/topology.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "mesh/shapes.h"

namespace sinew {
namespace {

using testing::ElementsAre;

/// What holds for every mesh, however broken.
void expect_consistent(const QuadMesh& mesh, const Topology& t) {
    const std::uint32_t half_edges = shapes::index_of(mesh.corners.size());
    ASSERT_EQ(t.edge_half_edges.size(), half_edges);
    ASSERT_EQ(t.vertex_half_edges.size(), half_edges);
    ASSERT_TRUE(std::is_sorted(t.edges.begin(), t.edges.end()));
    ASSERT_EQ(std::adjacent_find(t.edges.begin(), t.edges.end()), t.edges.end());
    for (std::uint32_t h = 0; h < half_edges; ++h) {
        const std::uint32_t a = mesh.corners[h], b = mesh.corners[next_half_edge(mesh, t, h)];
        ASSERT_EQ(t.edges[t.half_edge_edge[h]], (MeshEdge{std::min(a, b), std::max(a, b)}));
        ASSERT_EQ(find_edge(t, {a, b}), t.half_edge_edge[h]);
        ASSERT_EQ(previous_half_edge(mesh, t, next_half_edge(mesh, t, h)), h);
        if (t.twin[h] == no_index) continue;
        ASSERT_EQ(t.twin[t.twin[h]], h);
        ASSERT_EQ(mesh.corners[t.twin[h]], b);
    }
    std::vector<std::uint32_t> seen(t.vertex_half_edges);
    std::sort(seen.begin(), seen.end());
    for (std::uint32_t h = 0; h < half_edges; ++h) ASSERT_EQ(seen[h], h);
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
        for (const std::uint32_t h : t.ring(v)) ASSERT_EQ(mesh.corners[h], v);
}

/// Every ring is one closed fan, in counter-clockwise order.
void expect_closed_rings(const QuadMesh& mesh, const Topology& t) {
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        const auto ring = t.ring(v);
        for (std::size_t i = 0; i < ring.size(); ++i)
            ASSERT_EQ(counter_clockwise(mesh, t, ring[i]), ring[(i + 1) % ring.size()]);
    }
}

TEST(Topology, ClosedShapesHaveAllTwinsAndEulersEdges) {
    struct Case {
        QuadMesh mesh;
        std::size_t euler;
    };
    for (const auto& [mesh, euler] :
         {Case{shapes::cube(), 2}, Case{shapes::octahedron(), 2}, Case{shapes::torus(5, 7), 0},
          Case{shapes::tube(3, 200), 2}, Case{shapes::grid_cube(40), 2}}) {
        const Topology t = build_topology(mesh);
        expect_consistent(mesh, t);
        expect_closed_rings(mesh, t);
        EXPECT_EQ(std::count(t.twin.begin(), t.twin.end(), no_index), 0);
        EXPECT_EQ(t.edge_count(), mesh.vertex_count() + mesh.face_count() - euler);
    }
}

TEST(Topology, RingsTurnCounterClockwiseSeenFromOutside) {
    const QuadMesh mesh = shapes::octahedron();
    const Topology t = build_topology(mesh);
    const auto ring = t.ring(4);  // the top, seen from above: +x, +y, -x, -y
    ASSERT_EQ(ring.size(), 4u);
    Vec3f turn = Vec3f::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
        auto end = [&](std::size_t k) {
            return mesh.positions[mesh.corners[next_half_edge(mesh, t, ring[k % 4])]];
        };
        turn += end(i).cross(end(i + 1));
    }
    EXPECT_EQ(turn, Vec3f(0, 0, 4));
}

TEST(Topology, OpenFansStartAtTheirClockwiseEnd) {
    // Two triangles side by side over the edge 0-2: vertex 0's fan goes from 0-1-2 to 0-2-3.
    const QuadMesh mesh = shapes::from_faces(std::vector<Vec3f>(4, Vec3f::Zero()), {{0, 2, 3}, {0, 1, 2}});
    const Topology t = build_topology(mesh);
    expect_consistent(mesh, t);
    EXPECT_THAT(t.ring(0), ElementsAre(3, 0));
    EXPECT_EQ(counter_clockwise(mesh, t, 0), no_index);
    EXPECT_THAT(valences(t), ElementsAre(3, 2, 3, 2));
}

TEST(Topology, BrokenMeshesAreDescribedAsTheyAre) {
    const std::vector<Vec3f> points(7, Vec3f::Zero());
    // Three faces on the edge 0-1; a face that turns the wrong way; a repeated corner; a face of two corners.
    const QuadMesh mesh = shapes::from_faces(
        points, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {4, 2, 5}, {2, 4, 6}, {4, 2, 6, 6}, {5, 6}});
    const Topology t = build_topology(mesh);
    expect_consistent(mesh, t);
    EXPECT_EQ(t.half_edges(find_edge(t, {1, 0})).size(), 3u);
    EXPECT_EQ(t.twin[0], no_index);
    EXPECT_EQ(t.half_edges(find_edge(t, {6, 6})).size(), 1u);
    const QuadMesh flipped = shapes::with_face_flipped(shapes::cube(), 2);
    const Topology u = build_topology(flipped);
    expect_consistent(flipped, u);
    EXPECT_EQ(std::count(u.twin.begin(), u.twin.end(), no_index), 8);
    EXPECT_EQ(u.edge_count(), 12u);
}

TEST(Topology, EmptyMeshesAndLooseVertices) {
    EXPECT_EQ(build_topology(QuadMesh{}).edge_count(), 0u);
    const Topology t = build_topology(shapes::from_faces(std::vector<Vec3f>(5, Vec3f::Zero()), {{1, 2, 3}}));
    EXPECT_TRUE(t.ring(0).empty());
    EXPECT_TRUE(t.ring(4).empty());
    EXPECT_EQ(find_edge(t, {0, 4}), no_index);
}

TEST(Topology, WellFormedLooksAtEveryOffsetAndCorner) {
    EXPECT_TRUE(well_formed(QuadMesh{}));
    EXPECT_TRUE(well_formed(shapes::cube()));
    QuadMesh mesh = shapes::cube();
    mesh.corners[23] = 8;
    EXPECT_FALSE(well_formed(mesh));
    mesh = shapes::cube();
    mesh.face_offsets[2] = 20;
    EXPECT_FALSE(well_formed(mesh));
    mesh = shapes::cube();
    mesh.face_offsets.pop_back();
    EXPECT_FALSE(well_formed(mesh));
    mesh.face_offsets.clear();
    EXPECT_FALSE(well_formed(mesh));
}

}  // namespace
}  // namespace sinew
