#include "sinew/sqm/bridge/bridge.h"

#include <set>

#include "sinew/mesh/intersect.h"
#include "sinew/mesh/measure.h"
#include "sinew/mesh/validate.h"
#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

/// A mesh whose topology alone is looked at: positions are not set yet.
Bridge bridged(const Stages& s) {
    Bridge b = bridge(s.parts()).value();
    std::fill(b.mesh.positions.begin(), b.mesh.positions.end(), Vec3f::Zero());
    const Validation v = validate(b.mesh);
    EXPECT_TRUE(v.closed());
    EXPECT_TRUE(v.manifold());
    EXPECT_TRUE(v.oriented());
    EXPECT_FALSE(v.loose_vertices);
    return b;
}

/// Every vertex and face of the layout is there, and no other.
void expect_layout(const Stages& s, const Bridge& b) {
    std::size_t vertices = s.points.position.size(), faces = 0;
    for (std::int32_t p = 0; p < s.network.path_count(); ++p) {
        const std::int32_t rings = s.ring_count(p), sides = s.refinement.path_sides[p];
        const std::int64_t poles = (b.path_pole[p][0] != no_vertex) + (b.path_pole[p][1] != no_vertex);
        const std::int64_t bands = s.network.path_closed[p] ? rings : rings + 1 - poles;
        EXPECT_EQ(b.path_vertex[p], vertices);
        EXPECT_EQ(b.path_face[p], faces);
        vertices += rings * sides + poles;
        faces += (bands + poles) * sides;
    }
    EXPECT_EQ(b.path_face.back(), faces);
    EXPECT_EQ(b.capped_pole, vertices);
    for (const std::int32_t c : b.capped) faces += s.round_cell(c);
    EXPECT_EQ(b.mesh.positions.size(), vertices + b.capped.size() + 26 * s.network.lone.size());
    EXPECT_EQ(b.mesh.face_count(), faces + 24 * s.network.lone.size());
}

TEST(Bridge, LaysOutWhatItsHeaderSays) {
    property::Random random(23);
    Document d = random_tree(random, 3);
    d.links = {{3, 9}};
    add(d, -1, {20, 0, 0}, 1);
    for (const Document& each : {d, cube_of_struts(), star(fan(9))}) {
        const Stages s(each);
        expect_layout(s, bridged(s));
    }
}

TEST(Bridge, HasTheEulerNumberOfItsGraph) {
    property::Random random(24);
    for (int links = 0; links < 5; ++links) {
        Document d = random_tree(random, 3);
        for (int i = 0; i < links; ++i) d.links.push_back({1 + i, std::int32_t(d.nodes.size()) - 1 - i});
        const Stages s(d);
        EXPECT_EQ(validate(bridged(s).mesh).euler, 2 - 2 * links);
    }
}

TEST(Bridge, ATorusHasNoPolesAndNothingIrregular) {
    Document d = chain(fan(8), 0.1);
    d.links = {{0, 7}};
    const Bridge b = bridged(Stages(d));
    EXPECT_TRUE(b.mesh.features.poles.empty());
    EXPECT_EQ(validate(b.mesh).euler, 0);
    EXPECT_EQ(measure(b.mesh).irregular_vertices, 0);
}

/// The frame that is carried once round such a coil comes back turned, so that its last ring is joined to
/// other columns of the first: joined to the wrong ones, the tube between both would be wrung.
TEST(Bridge, JoinsTheLastRingOfAClosedCoilToTheFirstWithoutWringingIt) {
    int turned = 0;
    for (int waves = 1; waves <= 5; ++waves)
        for (const int sides : {4, 5, 8, 12}) {
            const Stages s(closed_coil(60, waves, 0.3), sides);
            Bridge b = bridge(s.parts()).value();
            place(s.parts(), {}, b);
            EXPECT_TRUE(find_self_intersections(b.mesh)->empty()) << waves << ' ' << sides;
            EXPECT_GT(measure(b.mesh).quad_quality.min, 0.7) << waves << ' ' << sides;
            // A shift for which its opposite cannot stand in.
            turned += 2 * s.stations.far_shift[0] % s.refinement.path_sides[0] != 0;
        }
    EXPECT_GT(turned, 10);
}

TEST(Bridge, TrianglesStandRoundPolesOnly) {
    const Stages s(star(fan(9)));
    const Bridge b = bridged(s);
    const std::set<std::uint32_t> poles(b.mesh.features.poles.begin(), b.mesh.features.poles.end());
    EXPECT_EQ(poles.size(), 11u);  // nine leaves, and two cells that part the spokes
    for (std::size_t f = 0; f < b.mesh.face_count(); ++f) {
        const auto face = b.mesh.face(f);
        const auto at = std::count_if(face.begin(), face.end(), [&](auto v) { return poles.count(v) > 0; });
        EXPECT_EQ(at, face.size() == 3 ? 1 : 0);
    }
}

TEST(Bridge, RingsOfJointsAreThoseThatThePathsEndIn) {
    const Stages s(cube_of_struts());
    const Parts parts = s.parts();
    std::vector<std::uint32_t> ring;
    for (std::int32_t p = 0; p < s.network.path_count(); ++p)
        for (int end = 0; end < 2; ++end) {
            joint_ring_of_path(parts, p, end, ring);
            const std::int32_t joint = s.network.path_end[p][end].joint;
            EXPECT_EQ(std::ssize(ring), s.refinement.path_sides[p]);
            for (const std::uint32_t v : ring) {
                EXPECT_GE(v, s.points.first[joint]);
                EXPECT_LT(v, s.points.first[joint + 1]);
            }
        }
}

TEST(Bridge, StopsOnRequest) {
    const std::atomic<bool> stop{true};
    const Stages s(star(fan(4)));
    const auto b = bridge(s.parts(), Progress({}, &stop));
    ASSERT_FALSE(b);
    EXPECT_EQ(b.error().kind, ErrorKind::cancelled);
}

}  // namespace
}  // namespace sinew::sqm
