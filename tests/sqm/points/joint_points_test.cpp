#include "sinew/sqm/points/joint_points.h"

#include <set>

#include "sinew/sqm/surface/dents.h"
#include "sinew/sqm/surface/joint_reach.h"
#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

TEST(JointPoints, LieOnTheRoundConesOfTheJoint) {
    property::Random random(15);
    for (int degree = 3; degree < 15; ++degree) {
        const Stages s(star(random_directions(random, degree), 5, 0.3));
        for (const Vec3& point : s.points.position) {
            const double exit = exit_of_joint(s.network, s.surfaces, 0, Vec3::Zero(), point.normalized());
            EXPECT_NEAR(point.norm(), exit, 1e-9);
            EXPECT_GE(point.norm(), 0.3 - 1e-9);
        }
    }
}

TEST(JointPoints, AreEvenAlongTheArcs) {
    const Stages s(star(fan(3)), 12);
    for (std::size_t a = 0; a < s.polyhedra.arcs.size(); ++a) {
        const std::int32_t pieces = s.refinement.pieces[a];
        const Vec3 from = s.polyhedra.vertices[s.polyhedra.arcs[a].from];
        for (std::int32_t i = 1; i < pieces; ++i) {
            const Vec3 ray = s.points.position[s.points.arc_first[a] + i - 1].normalized();
            EXPECT_NEAR(std::acos(ray.dot(from)), M_PI * i / pieces, 1e-6);
        }
    }
}

TEST(JointPoints, OfNarrowBundlesStayOnTheirHalfOfTheBones) {
    std::vector<Vec3> narrow = fan(3);
    for (Vec3& d : narrow) d = (0.15 * d + Vec3::UnitZ()).normalized();
    Document d = star(narrow, 4, 0.5);
    for (std::int32_t i = 1; i <= 3; ++i)
        for (const double up : {0.5, -0.5}) add(d, i, d.nodes[i].position + Vec3(0, 3 * up, 3), 0.3);
    const Stages s(d);
    for (std::uint32_t v = s.points.first[0]; v < s.points.first[1]; ++v)
        EXPECT_LT(s.points.position[v].z(), 0.95 * 4);
}

TEST(JointPoints, OfABoxAreItsCornersAndEvenOnItsEdges) {
    Document d = star(std::vector<Vec3>{Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitX()}, 4, 0.2);
    d.nodes[0].type = NodeType::cube;
    d.nodes[0].size = Vec3(1, 2, 3);
    const Stages s(d, 8);
    for (std::uint32_t v = 0; v < 8; ++v)
        EXPECT_TRUE(s.points.position[v].cwiseAbs().isApprox(Vec3(0.5, 1, 1.5), 1e-12));
    for (std::size_t a = 0; a < s.polyhedra.arcs.size(); ++a) {
        ASSERT_EQ(s.refinement.pieces[a], 2);
        const CellArc& arc = s.polyhedra.arcs[a];
        const Vec3 middle = 0.5 * (s.points.position[arc.from] + s.points.position[arc.to]);
        EXPECT_TRUE(s.points.position[s.points.arc_first[a]].isApprox(middle, 1e-12));
    }
}

/// The points of an arc with its ends, from the first on.
std::vector<Vec3> points_of_arc(const Stages& s, std::size_t a) {
    const CellArc& arc = s.polyhedra.arcs[a];
    std::vector<Vec3> points{s.points.position[arc.from]};
    for (std::int32_t i = 0; i + 1 < s.refinement.pieces[a]; ++i)
        points.push_back(s.points.position[s.points.arc_first[a] + i]);
    points.push_back(s.points.position[arc.to]);
    return points;
}
bool is_between_dents(const Stages& s, const CellArc& arc) {
    return std::max(arc.left, arc.right) < s.network.degree(0) &&
           dents_overlap(s.surfaces, arc.left, arc.right);
}

TEST(JointPoints, OfAnArcAcrossAGrooveGoFromRimToRim) {
    const Stages s(dented_ball(std::vector<double>{-0.25, 0.25}, 0.3, 0.2));
    int arcs = 0;
    for (std::size_t a = 0; a < s.polyhedra.arcs.size(); ++a) {
        if (!is_between_dents(s, s.polyhedra.arcs[a])) continue;
        ++arcs;
        const std::vector<Vec3> points = points_of_arc(s, a);
        std::vector<std::size_t> rims, sunk;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (on_rim(s.network, s.surfaces, 0, Vec3::Zero(), points[i])) rims.push_back(i);
            if (in_dent(s.network, s.surfaces, 0, Vec3::Zero(), points[i])) sunk.push_back(i);
        }
        ASSERT_EQ(rims.size(), 2u);
        EXPECT_EQ(sunk.size(), rims[1] - rims[0] - 1) << "all between the rims";
        EXPECT_GE(sunk.size(), 3u);
        // What is left of the arc outside is long: a point half way parts it.
        ASSERT_EQ(rims[0], 2u);
        ASSERT_EQ(rims[1], points.size() - 3);
        EXPECT_NEAR((points[1] - points[0]).norm(), (points[2] - points[1]).norm(), 1e-3);
        EXPECT_GT((points[1] - points[0]).norm(), 0.125);
    }
    EXPECT_EQ(arcs, 1);
}

TEST(JointPoints, OfArcsFromWhereThreeDentsMeetAreApart) {
    Document d = dented_ball(std::vector<double>{}, 0.3, 0.2);
    for (const Vec3& out : fan(3))
        d.nodes[add(d, 0, 1.2 * (0.25 * out + Vec3::UnitZ()).normalized(), 0.3)].type = NodeType::negative;
    const Stages s(d);
    int from_the_floor = 0;
    for (std::size_t a = 0; a < s.polyhedra.arcs.size(); ++a) {
        if (!is_between_dents(s, s.polyhedra.arcs[a])) continue;
        const std::vector<Vec3> points = points_of_arc(s, a);
        for (std::size_t i = 1; i < points.size(); ++i)
            EXPECT_GT((points[i].normalized() - points[i - 1].normalized()).norm(), 0.002) << i;
        from_the_floor += in_dent(s.network, s.surfaces, 0, Vec3::Zero(), points.front()) !=
                          in_dent(s.network, s.surfaces, 0, Vec3::Zero(), points.back());
    }
    EXPECT_EQ(from_the_floor, 3);
}

TEST(JointPoints, RingsRunCounterClockwiseRoundTheirCells) {
    property::Random random(16);
    const Stages s(star(random_directions(random, 7)), 8);
    std::vector<std::uint32_t> ring;
    for (std::int32_t c = 0; c < s.polyhedra.cell_count(); ++c) {
        ring.clear();
        for_ring(s.polyhedra, s.refinement, s.points, 0, c,
                 [&](std::uint32_t point) { ring.push_back(point); });
        EXPECT_EQ(std::ssize(ring), s.round_cell(c));
        EXPECT_EQ(std::set<std::uint32_t>(ring.begin(), ring.end()).size(), ring.size());
        EXPECT_LT(ring[0], s.polyhedra.vertices.size());
        Vec3 area = Vec3::Zero();
        for (std::size_t k = 0; k < ring.size(); ++k)
            area += s.points.position[ring[k]].cross(s.points.position[ring[(k + 1) % ring.size()]]);
        EXPECT_GT(area.dot(s.polyhedra.sites[c]), 0);
    }
}

}  // namespace
}  // namespace sinew::sqm
