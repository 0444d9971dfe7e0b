#include "sinew/mesh/triangulate.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "mesh/shapes.h"
#include "sinew/mesh/measure.h"

namespace sinew {
namespace {

using testing::SizeIs;
using testing::UnorderedElementsAre;

QuadMesh as_mesh(const QuadMesh& mesh) {
    QuadMesh result;
    result.positions = mesh.positions;
    for (const Triangle& triangle : triangulate(mesh).triangles) result.add_face(triangle);
    return result;
}

/// A flat face of these points.
QuadMesh polygon(const std::vector<Vec2>& outline) {
    QuadMesh mesh;
    for (const Vec2& p : outline) mesh.positions.emplace_back(float(p.x()), float(p.y()), 0.0f);
    std::vector<std::uint32_t> face(outline.size());
    for (std::size_t i = 0; i < face.size(); ++i) face[i] = shapes::index_of(i);
    mesh.add_face(face);
    return mesh;
}

/// No triangle is turned over: the areas add up to that of the face.
void expect_covers(const QuadMesh& face) {
    const QuadMesh triangles = as_mesh(face);
    EXPECT_EQ(triangles.face_count(), face.vertex_count() - 2);
    EXPECT_NEAR(measure(triangles).area, measure(face).area, 1e-5 * measure(face).area);
}

TEST(Triangulate, KeepsAreaVolumeAndClosedness) {
    for (const QuadMesh& mesh : {shapes::cube(), shapes::tube(4, 7), shapes::octahedron()}) {
        const QuadMesh triangles = as_mesh(mesh);
        EXPECT_TRUE(validate(triangles).solid());
        EXPECT_NEAR(measure(triangles).volume, measure(mesh).volume, 1e-6);
    }
}

TEST(Triangulate, QuadsAreCutAlongTheShorterDiagonalWhereverTheyStart) {
    const std::vector<Vec3f> kite{{-1, 0, 0}, {0, -3, 0.5f}, {1, 0, 0}, {0, 3, 0.5f}};
    for (std::uint32_t start = 0; start < 4; ++start) {
        QuadMesh mesh;
        mesh.positions = kite;
        mesh.add_face(std::array{start, (start + 1) % 4, (start + 2) % 4, (start + 3) % 4});
        for (const Triangle& t : triangulate(mesh).triangles) {
            EXPECT_THAT(t, testing::Contains(0u));
            EXPECT_THAT(t, testing::Contains(2u));
        }
    }
}

TEST(Triangulate, DartsAreCutInside) {
    for (const double tip : {0.2, 3.0}) expect_covers(polygon({{0, 0}, {2, -tip}, {0.5, 0.1}, {2, 4}}));
}

TEST(Triangulate, ConcavePolygonsAreCovered) {
    expect_covers(polygon({{0, 0}, {4, 0}, {4, 3}, {3, 3}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}));  // a U
    std::vector<Vec2> star, comb;
    for (int i = 0; i < 40; ++i) {
        const double a = 2 * std::numbers::pi * i / 40, r = i % 2 ? 1 : 4;
        star.emplace_back(r * std::cos(a), r * std::sin(a));
    }
    for (int i = 0; i < 50; ++i) comb.emplace_back(i, i % 2 ? 1 : 10);
    comb.insert(comb.end(), {{50, -1}, {-1, -1}});
    std::reverse(comb.begin(), comb.end());
    expect_covers(polygon(star));
    expect_covers(polygon(comb));
}

TEST(Triangulate, EveryFaceHasItsOwnAndSmallOnesHaveNone) {
    QuadMesh mesh = shapes::cube();
    mesh.add_face(std::array{0u, 1u});
    mesh.add_face(std::array{0u, 1u, 2u});
    const Triangles cut = triangulate(mesh);
    EXPECT_THAT(cut.of(5), SizeIs(2));
    EXPECT_THAT(cut.of(6), SizeIs(0));
    EXPECT_THAT(cut.of(7), UnorderedElementsAre(Triangle{0, 1, 2}));
    std::vector<Triangle> single;
    triangulate_face(mesh, 5, single);
    EXPECT_TRUE(std::equal(single.begin(), single.end(), cut.of(5).begin()));
}

TEST(Triangulate, FacesWithoutSenseEndToo) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<Vec2> tangle(700);
    for (Vec2& p : tangle) p = {uniform(random), uniform(random)};
    EXPECT_THAT(triangulate(polygon(tangle)).triangles, SizeIs(698));
    tangle.resize(60);
    EXPECT_THAT(triangulate(polygon(tangle)).triangles, SizeIs(58));
    EXPECT_THAT(triangulate(polygon(std::vector<Vec2>(9, Vec2(1, 1)))).triangles, SizeIs(7));
}

}  // namespace
}  // namespace sinew
