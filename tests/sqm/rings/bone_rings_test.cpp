#include "sinew/sqm/rings/bone_rings.h"

#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

/// A long bone from a joint of three to a leaf.
TEST(BoneRings, StandBesideTheJointAsWideAsTheTube) {
    const Stages s(star(fan(3), 10, 0.5));
    for (std::int32_t p = 0; p < s.network.path_count(); ++p) {
        const auto rings = s.rings(p);
        const auto beside = std::find_if(rings.begin(), rings.end(), [](const Station& ring) {
            return ring.shape == RingShape::circle && ring.fit == RingFit::through;
        });
        ASSERT_NE(beside, rings.end());
        EXPECT_LT(beside->centre.norm(), 1.5);
        EXPECT_NEAR(beside->half.x(), 0.5, 1e-12);
    }
}

TEST(BoneRings, OfASteepConeStandWhereItTouchesItsLargerBall) {
    for (const bool narrowing : {true, false}) {
        const double radius[] = {2, 2, 0.5, 0.5};
        Document d;
        for (int i = 0; i < 4; ++i)
            add(d, i - 1, {i < 2 ? 6.0 * i : 6.0 * i - 3, 0, 0}, radius[narrowing ? i : 3 - i]);
        const Stages s(d);
        const ConeFrom cone(d.nodes[1].position, d.nodes[1].radius, d.nodes[2].position, d.nodes[2].radius);
        const double height = narrowing ? cone.side_begin() : cone.side_end();
        const auto rings = s.rings(0);
        const auto there = std::find_if(rings.begin(), rings.end(), [&](const Station& ring) {
            return std::abs(ring.centre.x() - 6 - height) < 1e-9;
        });
        ASSERT_NE(there, rings.end()) << height;
        EXPECT_NEAR(there->half.x(), cone.radius_at(height), 1e-9);
    }
}

TEST(BoneRings, NameTheBoneAndWhereOnItTheyStand) {
    Document d;
    add(d, -1, {0, 0, 0}, 0.3);
    for (int i = 1; i <= 3; ++i) add(d, i - 1, {4.0 * i, 0.5 * i * i, 0}, 0.3);
    const Stages s(d);
    for (const Station& ring : s.rings(0)) {
        const Bone& bone = s.skeleton.bones[ring.bone];
        const Vec3 &a = s.skeleton.position[bone[0]], &b = s.skeleton.position[bone[1]];
        const double share = std::clamp((ring.centre - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
        EXPECT_NEAR(ring.along, share, 1e-6);
    }
}

TEST(BoneRings, AreAsDenseAsIsAskedFor) {
    const Stages s(star(fan(3), 40, 0.5));
    const auto longest = [&](const StationOptions& options) {
        const Stations stations =
            make_stations(s.skeleton, s.network, s.polyhedra, s.refinement, s.surfaces, s.points, options);
        double most = 0;
        for (std::int32_t p = 0; p < s.network.path_count(); ++p)
            for (std::int32_t i = stations.first[p] + 1; i < stations.first[p + 1]; ++i)
                most = std::max(most, (stations.stations[i].centre - stations.stations[i - 1].centre).norm());
        return most;
    };
    const double side = 2 * 0.5 * std::sin(M_PI / 4);  // of a ring of four
    EXPECT_GT(longest({}), 30);
    for (const double aspect : {1.0, 2.0, 5.0}) {
        EXPECT_LE(longest({.aspect = aspect}), aspect * side + 1e-9);
        EXPECT_GT(longest({.aspect = aspect}), 0.9 * aspect * side);
    }
    EXPECT_LE(longest({.edge_length = 0.3}), 0.3 + 1e-9);
    EXPECT_LE(longest({.support = true, .aspect = 2}), 2 * side + 1e-9);
}

}  // namespace
}  // namespace sinew::sqm
