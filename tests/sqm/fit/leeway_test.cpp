#include "sinew/sqm/fit/leeway.h"

#include "sinew/mesh/limit.h"
#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

TEST(Leeway, KeepsAPointBetweenItsLimits) {
    Leeway leeway{.start = {1, 0, 0}, .ray = Vec3::UnitX(), .out = 0.5, .in = 0.25, .far = 2};
    EXPECT_EQ(within(leeway, {1.4, 1, 0}), Vec3(1.4, 1, 0));
    EXPECT_NEAR((within(leeway, {3, 1, 0}) - Vec3(1.5, 1, 0)).norm(), 0, 1e-12);
    EXPECT_NEAR((within(leeway, {0, 1, 0}) - Vec3(0.75, 1, 0)).norm(), 0, 1e-12);
    EXPECT_NEAR((within(leeway, {1, 9, 0}) - leeway.start).norm(), 2, 1e-12);
    EXPECT_EQ(within(Leeway{}, {7, 8, 9}), Vec3(7, 8, 9));
}

TEST(Leeway, OfAStraightTubeStartsWhereItsLimitHasTheRadius) {
    const Stages s(chain(std::vector<Vec3>{{0, 0, 0}, {4, 0, 0}, {8, 0, 0}}, 0.5));
    for (const Station& ring : s.rings(0)) {
        if (ring.shape != RingShape::node) continue;
        const Leeway leeway = leeway_of_ring(s.skeleton, ring, 4, ring.centre + 0.5 * ring.x);
        EXPECT_NEAR((leeway.start - ring.centre).norm(), 0.5 / ring_limit_radius(4), 1e-12);
        EXPECT_EQ(leeway.out, leeway.in);
    }
}

/// Outside the bend there is the mitre to go to, inside there is not.
TEST(Leeway, AtABendGoesFartherOutside) {
    const Stages s(chain(std::vector<Vec3>{{0, 0, 0}, {6, 0, 0}, {6, 6, 0}}, 0.5));
    const auto rings = s.rings(0);
    const auto bend = std::find_if(rings.begin(), rings.end(),
                                   [](const Station& ring) { return ring.shape == RingShape::node; });
    ASSERT_NE(bend, rings.end());
    const Vec3 outside = Vec3(1, -1, 0).normalized();
    const Leeway out = leeway_of_ring(s.skeleton, *bend, 4, bend->centre + 0.5 * outside),
                 in = leeway_of_ring(s.skeleton, *bend, 4, bend->centre - 0.5 * outside);
    EXPECT_GT(out.out, in.out + 0.2);
    EXPECT_EQ(out.in, in.in);
}

/// A strip of two quads: the vertex in the middle of one side is pushed over the other end.
TEST(Leeway, UnfoldsWhatWasNotFoldedBefore) {
    QuadMesh mesh;
    for (const float y : {0.0f, 1.0f})
        for (const float x : {0.0f, 1.0f, 2.0f}) mesh.positions.emplace_back(x, y, 0);
    mesh.add_face(std::vector<std::uint32_t>{0, 1, 4, 3});
    mesh.add_face(std::vector<std::uint32_t>{1, 2, 5, 4});
    const PointGroups groups{{0, 1, 2, 3, 4, 5}, 0, 6};
    std::vector<Leeway> leeway(6);
    std::vector<Vec3> control;
    for (std::size_t v = 0; v < 6; ++v) control.push_back(leeway[v].start = mesh.positions[v].cast<double>());
    const std::vector<std::uint32_t> moving{1};
    std::vector<Vec3> little = control;
    little[1].x() = 1.5;
    unfold(mesh, groups, leeway, moving, little);
    EXPECT_EQ(little[1], Vec3(1.5, 0, 0));  // nothing is folded
    control[1].x() = 4;
    unfold(mesh, groups, leeway, moving, control);
    EXPECT_LT(control[1].x(), 2);
    EXPECT_GE(control[1].x(), 1);
    EXPECT_EQ(control[4], Vec3(1, 1, 0));
}

}  // namespace
}  // namespace sinew::sqm
