#include "sinew/sqm/rings/ring_form.h"

#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

Station ring_along(const Vec3& tangent) {
    Station ring;
    ring.tangent = tangent.normalized();
    ring.shape = RingShape::node;
    return ring;
}

TEST(RingForm, IsTurnedIntoThePlaneOfTheRing) {
    const Form form{.section = Section::rectangular, .half = {2, 1, 1}};
    Station ring = ring_along({0, 1, 2});
    take_form(form, ring);
    EXPECT_EQ(ring.shape, RingShape::outline);
    EXPECT_NEAR(ring.form_x.dot(ring.tangent), 0, 1e-12);
    EXPECT_TRUE(ring.form_x.isApprox(form.x, 1e-12));  // the bend turns about x
    EXPECT_EQ(ring.half, Vec2(2, 1));
}

TEST(RingForm, ThatIsFixedTurnsTheRing) {
    const Form form{.section = Section::rectangular, .fixed = true};
    Station ring = ring_along({1, 0, -2});
    take_form(form, ring);
    EXPECT_TRUE(ring.tangent.isApprox(-form.z));
    EXPECT_TRUE(ring.corners);
}

TEST(RingForm, OfAPlainCircleLeavesTheRingOnTheCones) {
    Station ring = ring_along({0, 0, 1});
    take_form(Form{}, ring);
    EXPECT_EQ(ring.shape, RingShape::node);
    take_form(Form{.sharpness = 1}, ring);
    EXPECT_EQ(ring.shape, RingShape::circle);
}

TEST(RingForm, BetweenTwoOutlinesIsTheOneBetweenThem) {
    Document d = star(fan(3), 8, 0.5);  // rings stand along the bones of a joint
    for (Node& node : d.nodes) node.section = Section::rectangular;
    for (std::size_t i = 1; i < d.nodes.size(); ++i) d.nodes[i].scale = {3, 1, 1};
    const Stages s(d);
    int between = 0;
    for (const Station& ring : s.stations.stations) {
        if (ring.shape != RingShape::outline || !(ring.along > 0 && ring.along < 1)) continue;
        EXPECT_NEAR(ring.half.maxCoeff(), 0.5 + ring.along, 1e-6);
        EXPECT_NEAR(ring.half.minCoeff(), 0.5, 1e-6);
        ++between;
    }
    EXPECT_GE(between, 3);
}

}  // namespace
}  // namespace sinew::sqm
