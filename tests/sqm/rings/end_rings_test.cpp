#include "sinew/sqm/rings/end_rings.h"

#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

/// A stick along x from 0 to 6, as wide at its end as one likes.
Document stick(double end_radius) {
    Document d;
    add(d, -1, {0, 0, 0}, 1);
    add(d, 0, {6, 0, 0}, end_radius);
    return d;
}

TEST(EndRings, OfARoundEndLieOnItsBallAndBeginWhereTheConeTouchesIt) {
    for (const double radius : {1.0, 0.6, 1.5}) {
        const Stages s(stick(radius), 12);
        const double touch = 6 + radius * (1 - radius) / 6;
        double first = 1e300;
        int rings = 0;
        for (const Station& ring : s.rings(0)) {
            if (ring.fit != RingFit::cap || ring.node != 1) continue;
            const double height = ring.centre.x() - 6;
            EXPECT_NEAR(std::hypot(height, ring.half.x()), radius, 1e-12);
            first = std::min(first, ring.centre.x());
            ++rings;
        }
        EXPECT_NEAR(first, touch, 1e-9);
        EXPECT_GE(rings, 2);
    }
}

TEST(EndRings, OfAFlatEndIsOneAtItsNode) {
    Document d = stick(0.7);
    d.nodes[1].type = NodeType::hemisphere;
    const Stages s(d);
    const Station last = s.rings(0).back();
    EXPECT_TRUE(last.centre.isApprox(Vec3(6, 0, 0), 1e-12));
    EXPECT_NEAR(last.half.x(), 0.7, 1e-12);
    EXPECT_EQ(last.fit, RingFit::through);
}

TEST(EndRings, OfATipAreNone) {
    Document d = stick(0.7);
    d.nodes[1].type = NodeType::cone;
    const Stages s(d);
    for (const Station& ring : s.rings(0)) EXPECT_LT(ring.centre.x(), 6);
}

}  // namespace
}  // namespace sinew::sqm
