#include "sinew/sqm/cells/polyhedra.h"

#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

TEST(Polyhedra, HaveACellABoneInTheOrderOfTheSlots) {
    property::Random random(6);
    const Plain skeleton = plain_of(random_tree(random, 3));
    const Network n = find_network(skeleton);
    const Polyhedra p = make_polyhedra(skeleton, n).value();
    ASSERT_EQ(p.joint_count(), n.joint_count());
    for (std::int32_t j = 0; j < n.joint_count(); ++j) {
        EXPECT_EQ(p.cell_first[j + 1] - p.cell_first[j], n.degree(j));
        EXPECT_LE(p.vertex_first[j + 1] - p.vertex_first[j], 2 * (n.degree(j) - 2));
        for (std::int32_t s = 0; s < n.degree(j); ++s)
            EXPECT_LT((p.sites[p.cell_first[j] + s] - slot_direction(skeleton, n, j, s)).norm(), 0.2);
        for (std::int32_t a = p.arc_first[j]; a < p.arc_first[j + 1]; ++a) {
            EXPECT_GE(std::min(p.arcs[a].left, p.arcs[a].right), p.cell_first[j]);
            EXPECT_LT(std::max(p.arcs[a].left, p.arcs[a].right), p.cell_first[j + 1]);
        }
    }
}

TEST(Polyhedra, OfAWheelHaveACellMoreOnEachSide) {
    const Plain skeleton = plain_of(star(fan(9)));
    const Polyhedra p = make_polyhedra(skeleton, find_network(skeleton)).value();
    ASSERT_EQ(p.cell_count(), 11);
    EXPECT_NEAR(std::abs(p.sites[9].z()), 1, 1e-9);
    EXPECT_TRUE(p.sites[9].isApprox(-p.sites[10], 1e-9));
}

TEST(Polyhedra, OfABoxHaveItsFacesForCells) {
    Document d = star(std::vector<Vec3>{Vec3(1, 0.2, 0.1).normalized(), Vec3(-0.1, 1, 0.2).normalized(),
                                        Vec3(0.1, 0.1, -1).normalized()});
    d.nodes[0].type = NodeType::cube;
    d.nodes[0].size = Vec3(1, 2, 3);
    const Plain skeleton = plain_of(d);
    const Polyhedra p = make_polyhedra(skeleton, find_network(skeleton)).value();
    EXPECT_EQ(p.cell_count(), 6);
    EXPECT_EQ(p.vertices.size(), 8u);
    EXPECT_EQ(p.arcs.size(), 12u);
    for (const Vec3& site : p.sites) EXPECT_NEAR(site.cwiseAbs().maxCoeff(), 1, 1e-12);
}

TEST(Polyhedra, ArcsRunBetweenTheirCells) {
    property::Random random(7);
    for (int degree = 3; degree < 12; ++degree) {
        const Plain skeleton = plain_of(star(random_directions(random, degree)));
        const Polyhedra p = make_polyhedra(skeleton, find_network(skeleton)).value();
        for (const CellArc& arc : p.arcs) {
            std::vector<Vec3> points(65);
            points.front() = p.vertices[arc.from];
            divide_arc(p, arc, 64, &points[1]);
            points.back() = p.vertices[arc.to];
            for (int i = 0; i < 64; ++i) {
                EXPECT_NEAR(points[i].norm(), 1, 1e-9);
                EXPECT_NEAR(2 * std::asin((points[i + 1] - points[i]).norm() / 2), arc_length(p, arc) / 64,
                            1e-7);
            }
            if (degree > 3) continue;
            const Vec3& middle = points[32];  // of a lune: equally near to both cells
            EXPECT_NEAR(middle.dot(p.sites[arc.left]), middle.dot(p.sites[arc.right]), 1e-9);
        }
    }
}

TEST(Polyhedra, StopOnRequest) {
    const std::atomic<bool> stop{true};
    const Plain skeleton = plain_of(star(fan(4)));
    const auto p = make_polyhedra(skeleton, find_network(skeleton), Progress({}, &stop));
    ASSERT_FALSE(p);
    EXPECT_EQ(p.error().kind, ErrorKind::cancelled);
}

}  // namespace
}  // namespace sinew::sqm
