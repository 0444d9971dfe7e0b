#include "sinew/sqm/outward.h"

#include <algorithm>

#include "sinew/mesh/measure.h"
#include "sinew/mesh/validate.h"
#include "sinew/sqm/skin.h"
#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

/// Struts, a star with cells that have no bone, a chain and a ball alone.
Document four_components() {
    Document d = cube_of_struts();
    const std::int32_t from = add(d, -1, {20, 0, 0}, 0.3);
    for (const Vec3& to : fan(9)) add(d, from, Vec3(20, 0, 0) + 3 * to, 0.2);
    add(d, add(d, -1, {40, 0, 0}, 0.3), {42, 0, 0}, 0.2);
    add(d, -1, {60, 0, 0}, 1);
    return d;
}

Bridge finished(const Stages& s) {
    Bridge b = bridge(s.parts()).value();
    finish(s, false, b);
    return b;
}

TEST(Outward, LeavesWhatIsOutward) {
    const Stages s(four_components());
    Bridge b = finished(s);
    const auto corners = b.mesh.corners;
    EXPECT_EQ(turn_outward(s.parts(), b), 0);
    EXPECT_EQ(b.mesh.corners, corners);
}

TEST(Outward, TurnsEveryComponentOfAMeshThatIsMirrored) {
    const Stages s(four_components());
    Bridge b = finished(s);
    const double volume = measure(b.mesh).volume;
    for (Vec3f& p : b.mesh.positions) p.x() = -p.x();
    ASSERT_EQ(validate(b.mesh).inward_components.count, 4);
    EXPECT_EQ(turn_outward(s.parts(), b), 4);
    const Validation v = validate(b.mesh);
    EXPECT_TRUE(v.closed() && v.manifold() && v.oriented() && v.outward());
    EXPECT_NEAR(measure(b.mesh).volume, volume, 1e-9 * volume);
}

TEST(Outward, TurnsOneComponentAloneAndKeepsTheFirstCornerOfItsFaces) {
    const Stages s(four_components());
    Bridge b = finished(s);
    const auto corners = b.mesh.corners;
    const auto lone = static_cast<std::uint32_t>(b.mesh.vertex_count()) - 26;
    for (std::uint32_t v = lone; v < b.mesh.vertex_count(); ++v)
        b.mesh.positions[v].y() = -b.mesh.positions[v].y();
    EXPECT_EQ(turn_outward(s.parts(), b), 1);
    for (std::size_t f = 0; f < b.mesh.face_count(); ++f) {
        const auto face = b.mesh.face(f);
        const auto* before = &corners[b.mesh.face_offsets[f]];
        EXPECT_EQ(face[0], before[0]);
        for (std::size_t i = 1; i < face.size(); ++i)
            EXPECT_EQ(face[i], face[0] < lone ? before[i] : before[face.size() - i]);
    }
}

TEST(Outward, LeavesAComponentWithoutVolume) {
    const Stages s(four_components());
    Bridge b = finished(s);
    for (Vec3f& p : b.mesh.positions) p.z() = 0;
    EXPECT_EQ(turn_outward(s.parts(), b), 0);
}

TEST(Outward, TurnsThePlanesOfABoxWithIt) {
    Document d = star(fan(3));
    d.nodes[0].type = NodeType::cube;
    const Stages s(d);
    Bridge b = finished(s);
    const auto planes = b.mesh.features.planes;
    ASSERT_FALSE(planes.empty());
    for (Vec3f& p : b.mesh.positions) p = -p;
    ASSERT_EQ(turn_outward(s.parts(), b), 1);
    for (std::size_t i = 0; i < planes.size(); ++i)
        EXPECT_EQ(b.mesh.features.planes[i].normal, Vec3f(-planes[i].normal));
}

/// A chain that is folded back on its own line, with radii that swallow each other.
TEST(Outward, HoldsForChainsFoldedBackOnTheirLine) {
    property::Random random(7);
    for (int i = 0; i < 300; ++i) {
        Document d;
        for (int k = random.whole(3, 6); k > 0; --k)
            add(d, d.nodes.empty() ? -1 : random.below(static_cast<int>(d.nodes.size())),
                {random.between(-5, 5), 0, 0}, std::pow(10, random.between(-4, 0)));
        const auto result = sinew::skin(d);
        ASSERT_TRUE(result);
        EXPECT_TRUE(validate(result->mesh).outward()) << i;
    }
}

}  // namespace
}  // namespace sinew::sqm
