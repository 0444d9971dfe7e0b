#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

std::vector<Station> rings_of(const Stages& s, std::int32_t path) {
    return {s.stations.stations.begin() + s.stations.first[path],
            s.stations.stations.begin() + s.stations.first[path + 1]};
}
std::vector<Station> at_nodes(const Stages& s, std::int32_t path) {
    std::vector<Station> rings = rings_of(s, path);
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
        for (const Station& ring : rings_of(s, p)) {
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

TEST(PathRings, OfASteepConeStandWhereItTouchesItsLargerBall) {
    for (const bool narrowing : {true, false}) {
        const double radius[] = {2, 2, 0.5, 0.5};
        Document d;
        for (int i = 0; i < 4; ++i)
            add(d, i - 1, {i < 2 ? 6.0 * i : 6.0 * i - 3, 0, 0}, radius[narrowing ? i : 3 - i]);
        const Stages s(d);
        const ConeFrom cone(d.nodes[1].position, d.nodes[1].radius, d.nodes[2].position, d.nodes[2].radius);
        const double height = narrowing ? cone.side_begin() : cone.side_end();
        const auto rings = rings_of(s, 0);
        const auto there = std::find_if(rings.begin(), rings.end(), [&](const Station& ring) {
            return std::abs(ring.centre.x() - 6 - height) < 1e-9;
        });
        ASSERT_NE(there, rings.end()) << height;
        EXPECT_NEAR(there->half.x(), cone.radius_at(height), 1e-9);
    }
}

TEST(PathRings, NameTheBoneAndWhereOnItTheyStand) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.3);
    for (int i = 1; i <= 3; ++i) add(d, i - 1, {4.0 * i, 0.5 * i * i, 0}, 0.3);
    const Stages s(d);
    for (const Station& ring : rings_of(s, 0)) {
        const Bone& bone = s.skeleton.bones[ring.bone];
        const Vec3 &a = s.skeleton.position[bone[0]], &b = s.skeleton.position[bone[1]];
        const double share = std::clamp((ring.centre - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
        EXPECT_NEAR(ring.along, share, 1e-6);
    }
}

}  // namespace
}  // namespace sinew::sqm
