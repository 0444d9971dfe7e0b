#include "sinew/sqm/rings/path_rings.h"

#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

std::vector<Station> at_nodes(const Stages& s, std::int32_t path) {
    std::vector<Station> rings = s.rings(path);
    std::erase_if(rings, [](const Station& ring) { return ring.shape != RingShape::node; });
    return rings;
}

TEST(PathRings, StandInTheBisectorOfEveryBend) {
    const std::vector<Vec3> places{{0, 0, 0}, {3, 0, 0}, {6, 2, 0}, {6, 2, 4}};
    const Stages s(chain(places, 0.4));
    const std::vector<Station> rings = at_nodes(s, 0);
    ASSERT_EQ(rings.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec3 in = (places[i + 1] - places[i]).normalized(),
                   out = (places[i + 2] - places[i + 1]).normalized();
        EXPECT_TRUE(rings[i].centre.isApprox(places[i + 1], 1e-12));
        EXPECT_NEAR(rings[i].tangent.dot(in), rings[i].tangent.dot(out), 1e-12);
        EXPECT_NEAR(rings[i].half.x(), 0.4, 1e-12);
        EXPECT_EQ(rings[i].node, std::int32_t(i) + 1);
    }
}

TEST(PathRings, ComeInTheirOrderAlongTheBones) {
    property::Random random(18);
    const Stages s(random_tree(random, 4));
    for (std::int32_t p = 0; p < s.network.path_count(); ++p) {
        const Vec3 from = s.skeleton.position[s.network.nodes(p).front()],
                   axis = s.skeleton.position[s.network.nodes(p).back()] - from;
        double before = -1;
        for (const Station& ring : s.rings(p)) {
            if (ring.shape == RingShape::follow) continue;
            const double along = (ring.centre - from).dot(axis);
            EXPECT_GT(along, before);
            EXPECT_TRUE(ring.tangent.cross(axis).isZero(1e-9));
            before = along;
        }
    }
}

TEST(PathRings, InsideAJointsBallAreLeftOut) {
    Document d = star(fan(3), 1.0, 2.0);
    for (std::int32_t i = 1; i <= 3; ++i) add(d, i, 8 * d.nodes[i].position, 0.5);
    const Stages s(d);
    for (std::int32_t p = 0; p < s.network.path_count(); ++p) EXPECT_TRUE(at_nodes(s, p).empty());
}

}  // namespace
}  // namespace sinew::sqm
