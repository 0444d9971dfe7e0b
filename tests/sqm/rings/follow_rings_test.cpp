#include "sinew/sqm/rings/follow_rings.h"

#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

bool follows(const Station& ring) { return ring.shape == RingShape::follow; }

TEST(FollowRings, LieBetweenTheJointAndItsFirstRing) {
    Document d = star(std::vector<Vec3>{Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitY()}, 6, 0.5);
    d.nodes[0].type = NodeType::ball;
    d.nodes[0].radius = 2;
    const Stages s(d);
    int follow = 0;
    for (const Station& ring : s.stations.stations) {
        if (ring.shape != RingShape::follow) continue;
        EXPECT_GT(ring.share, 0);
        EXPECT_LT(ring.share, 1);
        ++follow;
    }
    EXPECT_GT(follow, 0);
}

TEST(FollowRings, AreNotNeededWhereTubesOfOneRadiusMeetEvenly) {
    const Stages s(star(fan(4), 8, 0.5));
    for (const Station& ring : s.stations.stations) EXPECT_FALSE(follows(ring));
}

}  // namespace
}  // namespace sinew::sqm
