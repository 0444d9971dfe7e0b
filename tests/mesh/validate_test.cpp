#include "sinew/mesh/validate.h"

#include <gmock/gmock.h>

#include <limits>

#include "mesh/shapes.h"

namespace sinew {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

TEST(Validate, ShapesOfKnownGenusAreSolid) {
    struct Case {
        QuadMesh mesh;
        int components, euler;
    };
    const QuadMesh torus = shapes::torus(6, 5);
    for (const auto& [mesh, components, euler] :
         {Case{shapes::cube(), 1, 2}, Case{shapes::octahedron(), 1, 2}, Case{torus, 1, 0},
          Case{shapes::tube(5, 900), 1, 2}, Case{shapes::grid_cube(50), 1, 2},
          Case{shapes::together(shapes::cube(), torus), 2, 2}, Case{shapes::together(torus, torus), 2, 0}}) {
        const Validation v = validate(mesh);
        EXPECT_TRUE(v.solid());
        EXPECT_EQ(v.components, components);
        EXPECT_EQ(v.euler, euler);
        EXPECT_EQ(v.vertices - v.edges + v.faces, v.euler);
        EXPECT_FALSE(v.loose_vertices);
    }
}

TEST(Validate, ABoxWithoutItsLidIsOpen) {
    const Validation v = validate(shapes::without_faces(shapes::cube(), {1}));
    EXPECT_FALSE(v.closed());
    EXPECT_TRUE(v.manifold());
    EXPECT_TRUE(v.oriented());
    EXPECT_EQ(v.euler, 1);
    EXPECT_THAT(v.boundary_edges.examples,
                ElementsAre(MeshEdge{4, 5}, MeshEdge{4, 6}, MeshEdge{5, 7}, MeshEdge{6, 7}));
}

TEST(Validate, AFaceTurnedOverIsStillManifold) {
    const Validation v = validate(shapes::with_face_flipped(shapes::cube(), 3));
    EXPECT_EQ(v.flipped_edges.count, 4);
    EXPECT_FALSE(v.oriented());
    EXPECT_TRUE(v.closed());
    EXPECT_TRUE(v.manifold());
}

TEST(Validate, AMoebiusBandIsManifoldButCannotBeOriented) {
    QuadMesh band;
    band.positions.assign(10, Vec3f::Zero());
    for (std::uint32_t i = 0; i < 4; ++i) band.add_face(std::array{2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
    band.add_face(std::array{8u, 1u, 0u, 9u});
    const Validation v = validate(band);
    EXPECT_EQ(v.euler, 0);
    EXPECT_EQ(v.boundary_edges.count, 10);
    EXPECT_EQ(v.flipped_edges.count, 1);
    EXPECT_TRUE(v.manifold());
}

TEST(Validate, AKleinBottleIsClosedAndManifoldButNotOriented) {
    const std::size_t m = 6, n = 6;
    QuadMesh klein;
    klein.positions.assign(m * n, Vec3f::Zero());
    auto at = [&](std::size_t i, std::size_t j) {  // coming round once turns the ring over
        return shapes::index_of(i == m ? (n - j % n) % n : i * n + j % n);
    };
    for (std::size_t i = 0; i < m; ++i)
        for (std::size_t j = 0; j < n; ++j)
            klein.add_face(std::array{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    const Validation v = validate(klein);
    EXPECT_TRUE(v.closed());
    EXPECT_TRUE(v.manifold());
    EXPECT_EQ(v.euler, 0);
    EXPECT_EQ(v.flipped_edges.count, std::int64_t{n});
}

TEST(Validate, CubesThatShareAVertexOrAnEdge) {
    const QuadMesh cube = shapes::cube();
    QuadMesh pair = shapes::together(cube, shapes::moved(cube, {1, 1, 1}));
    for (std::uint32_t& v : pair.corners) v = v == 8 ? 7 : v;
    const Validation vertex = validate(pair);
    EXPECT_THAT(vertex.nonmanifold_vertices.examples, ElementsAre(7));
    EXPECT_THAT(vertex.loose_vertices.examples, ElementsAre(8));
    EXPECT_FALSE(vertex.manifold());
    EXPECT_TRUE(vertex.closed());
    EXPECT_EQ(vertex.components, 1);

    pair = shapes::together(cube, shapes::moved(cube, {1, 1, 0}));
    for (std::uint32_t& v : pair.corners) v = v == 8 ? 3 : v == 12 ? 7 : v;
    const Validation edge = validate(pair);
    EXPECT_THAT(edge.nonmanifold_edges.examples, ElementsAre(MeshEdge{3, 7}));
    EXPECT_FALSE(edge.manifold());
    EXPECT_FALSE(edge.flipped_edges);
}

TEST(Validate, SmallAndRepeatingFaces) {
    QuadMesh mesh = shapes::cube();
    mesh.add_face(std::array{0u, 1u});
    mesh.add_face(std::array{0u, 1u, 3u, 0u});
    mesh.add_face(std::array{0u, 1u, 2u, 3u, 4u, 5u, 6u, 7u, 2u});
    const Validation v = validate(mesh);
    EXPECT_THAT(v.small_faces.examples, ElementsAre(6));
    EXPECT_THAT(v.repeating_faces.examples, ElementsAre(7, 8));
    EXPECT_FALSE(v.manifold());
}

TEST(Validate, ComponentsTurnedInsideOutAreNamed) {
    QuadMesh far = shapes::moved(shapes::sphere(3), {1e4f, 0, 0});
    for (std::size_t f = 0; f < far.face_count(); ++f) far = shapes::with_face_flipped(far, f);
    const QuadMesh mesh = shapes::together(shapes::cube(), far);
    const Validation v = validate(mesh);
    EXPECT_THAT(v.inward_components.examples, ElementsAre(8));
    EXPECT_TRUE(v.oriented());
    EXPECT_FALSE(v.outward());
}

TEST(Validate, BadIndicesOffsetsAndNumbersAreReportedNotFollowed) {
    QuadMesh mesh = shapes::cube();
    mesh.corners[5] = 8;
    mesh.corners[7] = 0xffffffff;
    Validation v = validate(mesh);
    EXPECT_THAT(v.bad_corners.examples, ElementsAre(5, 7));
    EXPECT_FALSE(v.closed());
    mesh = shapes::cube();
    mesh.face_offsets[3] = 99;
    EXPECT_FALSE(validate(mesh).sound_offsets);
    mesh = shapes::cube();
    mesh.positions[3].y() = std::numeric_limits<float>::quiet_NaN();
    mesh.positions[6].z() = -std::numeric_limits<float>::infinity();
    v = validate(mesh);
    EXPECT_THAT(v.non_finite.examples, ElementsAre(3, 6));
    EXPECT_FALSE(v.solid());
    EXPECT_TRUE(v.closed());
}

TEST(Validate, ExamplesAreTheFirstFew) {
    QuadMesh mesh = shapes::grid_cube(60);
    std::vector<std::uint32_t> expected;
    for (std::uint32_t v = 0; v < mesh.vertex_count(); v += 100) {
        mesh.positions[v].x() = std::numeric_limits<float>::infinity();
        if (expected.size() < IndexFaults::most_examples) expected.push_back(v);
    }
    const Validation v = validate(mesh);
    EXPECT_EQ(v.non_finite.count, std::int64_t((mesh.vertex_count() + 99) / 100));
    EXPECT_EQ(v.non_finite.examples, expected);
}

}  // namespace
}  // namespace sinew
