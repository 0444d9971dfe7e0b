#include "sinew/sqm/place/symmetrise.h"

#include <algorithm>

#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

/// A spine in the plane x = 0 with limbs that branch on both sides of it.
Document biped() {
    Document d;
    add(d, -1, {0, 0, 0}, 0.4);
    add(d, 0, {0, 4, 1}, 0.4);
    for (const double side : {-1.0, 1.0}) {
        const std::int32_t elbow = add(d, 0, {side * 3, 1, 0.5}, 0.3);
        add(d, elbow, {side * 6, 0, 1}, 0.2);
        add(d, elbow, {side * 6, 2.5, -1}, 0.25);
        add(d, 1, {side * 3, 6, 2}, 0.2);
    }
    return d;
}

TEST(Symmetrise, EveryVertexHasOneImageWhichIsThatOfItsImage) {
    const Stages s(biped());
    ASSERT_TRUE(s.images.any());
    Bridge b = bridge(s.parts()).value();
    finish(s, false, b);
    const auto image = vertex_images(s.parts(), s.images, b);
    ASSERT_EQ(image.size(), b.mesh.vertex_count());
    for (std::uint32_t v = 0; v < image.size(); ++v) {
        ASSERT_LT(image[v], image.size());
        EXPECT_EQ(image[image[v]], v);
    }
}

/// Faces go to faces, whose corners run the other way round as the symmetry is a mirror.
void expect_faces_to_go_to_faces(const QuadMesh& mesh, const std::vector<std::uint32_t>& image) {
    const auto rotated = [](std::vector<std::uint32_t> face) {
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
        return face;
    };
    std::vector<std::vector<std::uint32_t>> faces, images;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        std::vector<std::uint32_t> face(mesh.face(f).begin(), mesh.face(f).end());
        faces.push_back(rotated(face));
        std::reverse(face.begin(), face.end());
        for (std::uint32_t& v : face) v = image[v];
        images.push_back(rotated(face));
    }
    std::sort(faces.begin(), faces.end());
    std::sort(images.begin(), images.end());
    EXPECT_EQ(faces, images);
}

TEST(Symmetrise, FacesGoToFacesInTheOtherSense) {
    const Stages s(biped());
    Bridge b = bridge(s.parts()).value();
    finish(s, false, b);
    expect_faces_to_go_to_faces(b.mesh, vertex_images(s.parts(), s.images, b));
}

TEST(Symmetrise, MakesPositionsImagesToTheLastBit) {
    Images images;
    images.order = 2;
    images.generator(0, 0) = -1;
    images.reverses = true;
    std::vector<Vec3f> positions{{1.0001f, 2, 3}, {-1, 2.0001f, 3}, {0.001f, 5, 6}, {9, 9, 9}};
    make_symmetric(images, std::vector<std::uint32_t>{1, 0, 2, no_vertex}, positions);
    EXPECT_EQ(positions[1], Vec3f(-positions[0].x(), positions[0].y(), positions[0].z()));
    EXPECT_EQ(positions[2], Vec3f(0, 5, 6));  // its own image: into the mirror
    EXPECT_EQ(positions[3], Vec3f(9, 9, 9));  // without one: as it was
}

/// Closed coils and their images in the plane x = 0. Of the image the nodes are drawn from another one on,
/// forwards or backwards, so that the walk along both passes the seam of the image in either sense.
TEST(Symmetrise, FindsImagesOfClosedCoilsWhicheverWayTheyAreDrawn) {
    for (const bool backwards : {false, true})
        for (const int waves : {2, 3, 5})
            for (const int seam : {0, 7, 30}) {
                const int nodes = 60;
                const Document coil = closed_coil(nodes, waves, 0.3);
                Document d = coil;
                for (int i = 0; i < nodes; ++i) {
                    const int of = (seam + (backwards ? nodes - i : i)) % nodes;
                    const Vec3& at = coil.nodes[of].position;
                    d.nodes[of].position = at + Vec3(10, 0, 0);
                    add(d, i == 0 ? -1 : nodes + i - 1, {-at.x() - 10, at.y(), at.z()}, 0.3);
                }
                d.links.push_back({nodes, 2 * nodes - 1});
                const Stages s(d, 7);
                ASSERT_TRUE(s.images.any());
                EXPECT_NE(2 * s.stations.far_shift[1] % 7, 0);
                Bridge b = bridge(s.parts()).value();
                place(s.parts(), {}, b);
                const auto image = vertex_images(s.parts(), s.images, b);
                ASSERT_EQ(image.size(), b.mesh.vertex_count());
                for (const std::uint32_t v : image)
                    ASSERT_NE(v, no_vertex) << backwards << ' ' << waves << ' ' << seam;
                expect_faces_to_go_to_faces(b.mesh, image);
            }
}

TEST(Symmetrise, PlacesAMirroredSkeletonExactly) {
    const Stages s(biped());
    for (const bool limit : {false, true}) {
        Bridge b = bridge(s.parts()).value();
        finish(s, limit, b);
        const auto image = vertex_images(s.parts(), s.images, b);
        for (std::uint32_t v = 0; v < image.size(); ++v) {
            const Vec3f &p = b.mesh.positions[v], &q = b.mesh.positions[image[v]];
            EXPECT_EQ(p.x(), -q.x());
            EXPECT_EQ(p.y(), q.y());
            EXPECT_EQ(p.z(), q.z());
        }
    }
}

}  // namespace
}  // namespace sinew::sqm
