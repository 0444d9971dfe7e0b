#include "sinew/io/ngon_encoding.h"

#include <gmock/gmock.h>

#include "mesh/shapes.h"

namespace sinew {
namespace {

using testing::ElementsAre;

QuadMesh decoded(const std::vector<Triangle>& triangles) {
    QuadMesh mesh;
    decode_ngons(triangles, mesh);
    return mesh;
}

TEST(NgonEncoding, PolygonsComeBack) {
    for (const QuadMesh& mesh :
         {shapes::cube(), shapes::tube(5, 8), shapes::torus(9, 4), shapes::grid_cube(7)}) {
        const std::vector<Triangle> triangles = encode_ngons(mesh);
        QuadMesh decoded;
        decoded.positions = mesh.positions;
        decode_ngons(triangles, decoded);
        ASSERT_EQ(decoded.face_offsets, mesh.face_offsets);
        for (std::size_t f = 0; f < mesh.face_count(); ++f) {  // a face may start with another corner
            std::vector<std::uint32_t> face(mesh.face(f).begin(), mesh.face(f).end());
            std::rotate(face.begin(), std::find(face.begin(), face.end(), decoded.face(f)[0]), face.end());
            EXPECT_TRUE(std::equal(face.begin(), face.end(), decoded.face(f).begin()));
        }
    }
}

TEST(NgonEncoding, TrianglesRoundAPoleStayApart) {
    QuadMesh decoded;
    decode_ngons(encode_ngons(shapes::octahedron()), decoded);
    EXPECT_EQ(decoded.face_count(), 8u);
}

TEST(NgonEncoding, TrianglesThatGoOnFromTheirDiagonalAreOnePolygon) {
    const QuadMesh mesh = decoded({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {5, 6, 7}});
    EXPECT_THAT(mesh.face_offsets, ElementsAre(0, 5, 8));
    EXPECT_THAT(mesh.corners, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
}

TEST(NgonEncoding, OneVertexInCommonMakesNoPolygon) {
    // Other writers keep the first vertex of neighbours that are no fan; a polygon of them would cross
    // itself.
    EXPECT_THAT(decoded({{0, 1, 2}, {0, 3, 4}}).face_offsets, ElementsAre(0, 3, 6));
    EXPECT_THAT(decoded({{0, 2, 3}, {0, 1, 2}}).face_offsets, ElementsAre(0, 3, 6));
    EXPECT_THAT(decoded({{0, 1, 2}, {1, 2, 3}}).face_offsets, ElementsAre(0, 3, 6));
}

TEST(NgonEncoding, PolygonsThatFollowEachOtherStartWithDifferentVertices) {
    // All of these start with vertex 0 as they are given.
    const QuadMesh mesh =
        shapes::from_faces({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}},
                           {{0, 1, 2, 3}, {0, 3, 4, 5}, {0, 5, 6}});
    const std::vector<Triangle> triangles = encode_ngons(mesh);
    const QuadMesh back = decoded(triangles);
    ASSERT_THAT(back.face_offsets, ElementsAre(0, 4, 8, 11));
    for (std::size_t f = 1; f < back.face_count(); ++f) EXPECT_NE(back.face(f)[0], back.face(f - 1)[0]) << f;
}

}  // namespace
}  // namespace sinew
