#include "sinew/sqm/place/place.h"

#include <array>

#include "sinew/mesh/deviation.h"
#include "sinew/mesh/intersect.h"
#include "sinew/mesh/measure.h"
#include "sinew/mesh/validate.h"
#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

QuadMesh placed(const Stages& s, PlaceOptions options = {}) {
    Bridge b = bridge(s.parts()).value();
    place(s.parts(), options, b);
    EXPECT_TRUE(validate(b.mesh).solid());
    return b.mesh;
}
RoundCones cones_of(const Plain& skeleton) {
    RoundCones cones;
    for (const auto& [a, b] : skeleton.bones)
        cones.add(skeleton.position[a], skeleton.radius[a], skeleton.position[b], skeleton.radius[b]);
    return cones;
}

TEST(Place, RingsOfStraightTubesHaveTheRadius) {
    property::Random random(26);
    for (const int sides : {0, 7, 16}) {
        const Vec3 axis = random.direction(), from = random.in_cube(3);
        const Stages s(chain(std::vector<Vec3>{from, from + 3 * axis, from + 5 * axis, from + 9 * axis}, 0.7),
                       sides);
        const QuadMesh mesh = placed(s);
        int rings = 0;
        for (const Vec3f& p : mesh.positions) {
            const Vec3 out = p.cast<double>() - from;
            const double along = out.dot(axis);
            if (along < 0.01 || along > 8.99) continue;
            EXPECT_NEAR((out - along * axis).norm() / 0.7, 1, 0.001);
            ++rings;
        }
        EXPECT_GE(rings, 2 * std::max(4, sides));
    }
}

TEST(Place, RingsOfConesAndBendsLieOnTheRoundCones) {
    Document d;
    add(d, -1, {0, 0, 0}, 1);
    add(d, 0, {5, 0, 0}, 0.6);
    add(d, 1, {9, 3, 0}, 0.8);
    add(d, 2, {9, 3, 6}, 0.3);
    const Stages s(d);
    const Deviation deviation = measure_deviation(placed(s), cones_of(s.skeleton));
    EXPECT_LT(deviation.mean_abs, 0.001);
    EXPECT_LT(deviation.max_abs, 0.01);
}

/// Joints on bones too short for both: rings that follow their surfaces stay where the joints do.
TEST(Place, RingsThatFollowAJointStayInItsPartOfTheBone) {
    const std::vector<std::vector<Ball>> trees{{{-1, {0.01, -0.75, 0.75}, 0.75},
                                                {0, {0, 0, 0}, 1},
                                                {1, {-0.355, 1.03, -1.28}, 1.37},
                                                {2, {-0.827, 1.07, -2.47}, 1.11},
                                                {2, {-2.5, 1.35, -1.35}, 0.651},
                                                {1, {0.572, 1.63, 0.33}, 0.745},
                                                {2, {-0.267, 3.03, -0.789}, 0.42}},
                                               {{-1, {2.78, -0.55, 0.96}, 0.94},
                                                {0, {0.56, 0.14, 0.42}, 0.88},
                                                {1, {0, 0, 0}, 1},
                                                {2, {-0.29, -0.07, -0.22}, 1.06},
                                                {3, {-0.58, 0.12, -0.51}, 1.06},
                                                {4, {-0.97, 0.38, -0.9}, 1.06},
                                                {2, {-1.24, -0.78, 0.73}, 0.12},
                                                {6, {-1.47, -1.02, 1.2}, 0.36},
                                                {4, {-1.71, 0.4, 0.25}, 0.36},
                                                {3, {0.18, -1.26, -0.93}, 0.22}}};
    for (const std::vector<Ball>& balls : trees)
        EXPECT_TRUE(find_self_intersections(placed(Stages(tree(balls))))->empty());
}

TEST(Place, RingsOfTightBendsDoNotCross) {
    for (const double angle : {1.2, 1.8, 2.4, 2.8}) {  // bones no longer than their balls are thick
        const Vec3 on(std::cos(angle), std::sin(angle), 0);
        const Stages s(chain(std::vector<Vec3>{{-1, 0, 0}, {0, 0, 0}, on, on + Vec3::UnitX()}, 0.6));
        Bridge b = bridge(s.parts()).value();
        finish(s, false, b);
        EXPECT_FALSE(measure(b.mesh).folded_quads) << angle;
    }
}

/// Where both ends of a bone have a ring at a bend, neither leans over the bone to its middle; nor does one
/// over the bone to a joint.
TEST(Place, RingsOfBendsShareTheBoneBetweenThem) {
    property::Random random(29);
    std::array<int, 2> held{};  // towards a bend, a joint
    for (int round = 0; round < 400; ++round) {
        const bool from_joint = round % 2 == 1;
        std::vector<Ball> balls{{-1, {0, 0, 0}, from_joint ? 0.3 : random.between(0.4, 0.9)}};
        for (int i = 0; i < 4; ++i)
            balls.push_back({i, balls.back().position + random.direction(), random.between(0.4, 0.9)});
        for (int i = 0; from_joint && i < 2; ++i) balls.push_back({0, 3 * random.direction(), 0.3});
        const Stages s(tree(balls));
        Bridge b = bridge(s.parts()).value();
        place(s.parts(), {}, b);
        for (std::int32_t p = 0; p < s.network.path_count(); ++p) {
            const auto nodes = s.network.nodes(p);
            for (std::int32_t i = s.stations.first[p]; i < s.stations.first[p + 1]; ++i) {
                const Station& ring = s.stations.stations[i];
                if (ring.shape != RingShape::node) continue;
                for (const std::int32_t next : {ring.before, ring.after}) {
                    const bool first = next == nodes.front(), inner = !first && next != nodes.back();
                    const bool joint = !inner && s.network.path_end[p][first ? 0 : 1].at_joint();
                    if (!inner && !joint) continue;
                    const Vec3 centre = s.skeleton.position[ring.node],
                               bone = s.skeleton.position[next] - centre;
                    for (std::int32_t k = 0; k < s.refinement.path_sides[p]; ++k) {
                        const Vec3 at =
                            b.mesh.positions[first_of_ring(s.parts(), b, p, i) + k].cast<double>() - centre;
                        const double height = at.dot(bone) / bone.squaredNorm();
                        EXPECT_LT(height, 0.5 + 1e-5);
                        held[joint ? 1 : 0] += height > 0.48;
                    }
                }
            }
        }
    }
    for (const int count : held) EXPECT_GT(count, 10) << "that some would lean further";
}

/// A sharp turn into a short last bone: the ring of the turn stays off the rings of the round end, which
/// begin where the side of that bone ends, and off its own centre even if the end's ball swallows the whole
/// side.
TEST(Place, RingsOfBendsStayOffTheRoundEndBeyond) {
    for (const double turn : {1.6, 2.0, 2.4})
        for (const auto& [near, far] :
             {std::pair(0.9, 0.9), {0.9, 0.2}, {0.3, 1.0}, {0.15, 1.0}, {0.12, 1.05}}) {
            const Vec3 last(std::cos(turn), std::sin(turn), 0);
            const Stages s(
                tree(std::vector<Ball>{{-1, {-6, 0, 0}, near}, {0, {0, 0, 0}, near}, {1, last, far}}));
            Bridge b = bridge(s.parts()).value();
            place(s.parts(), {}, b);
            const ConeFrom bone({0, 0, 0}, near, last, far);
            for (std::int32_t i = 0; i < s.ring_count(0); ++i) {
                if (s.stations.stations[i].shape != RingShape::node) continue;
                for (std::int32_t k = 0; k < s.refinement.path_sides[0]; ++k) {
                    const Vec3 at = b.mesh.positions[first_of_ring(s.parts(), b, 0, i) + k].cast<double>();
                    EXPECT_LT(at.dot(last), std::max(bone.side_end(), 0.1))
                        << turn << ' ' << near << ' ' << far;
                    EXPECT_GT(at.norm(), 0.05) << turn << ' ' << near << ' ' << far;
                }
            }
        }
}

TEST(Place, VerticesOfTreesLieOnTheRoundCones) {
    property::Random random(27);
    for (int round = 0; round < 10; ++round) {
        const Stages s(star(random_directions(random, 3 + round), 8, 0.4));
        EXPECT_LT(measure_deviation(placed(s), cones_of(s.skeleton)).mean_abs, 0.01);
    }
}

TEST(Place, VerticesKnowTheirNodeAndBone) {
    const Stages s(star(fan(4), 5, 0.3));
    const QuadMesh mesh = placed(s);
    ASSERT_EQ(mesh.vertex_node.size(), mesh.vertex_count());
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        const Vec3 p = mesh.positions[v].cast<double>();
        ASSERT_GE(mesh.vertex_node[v], 0);
        if (mesh.vertex_bone[v] < 0) continue;
        const Bone& bone = s.skeleton.bones[mesh.vertex_bone[v]];
        const Vec3 on_bone = (1 - mesh.vertex_along[v]) * s.skeleton.position[bone[0]] +
                             mesh.vertex_along[v] * s.skeleton.position[bone[1]];
        EXPECT_LT((p - on_bone).norm(), 0.3 * 1.5);
    }
}

TEST(Place, AsBridgedLeavesJointsOnTheirBalls) {
    const Stages s(star(fan(5), 5, 0.3));
    const QuadMesh mesh = placed(s, {.ideal = false});
    for (std::size_t v = 0; v < s.points.position.size(); ++v)
        EXPECT_NEAR(mesh.positions[v].norm(), 0.3, 1e-6);
}

TEST(Place, LoneBallsAndBoxesAreExact) {
    Document d;
    add(d, -1, {1, 2, 3}, 2);
    const QuadMesh ball = placed(Stages(d));
    for (const Vec3f& p : ball.positions) EXPECT_NEAR((p - Vec3f(1, 2, 3)).norm(), 2, 1e-5);
    d.nodes[0].type = NodeType::cube;
    d.nodes[0].size = Vec3(1, 2, 4);
    for (const Vec3f& p : placed(Stages(d)).positions)
        EXPECT_NEAR((p - Vec3f(1, 2, 3)).cwiseQuotient(Vec3f(0.5f, 1, 2)).cwiseAbs().maxCoeff(), 1, 1e-5);
}

TEST(Place, KeepsRingsOfBendsApart) {
    Document to_a_ball;  // whose first ring stands far up the bone
    const std::array<double, 4> radii{0.85, 0.54, 0.16, 0.75};
    const std::array<Vec3, 4> places{
        Vec3(0, 0, 0.1), {-0.23, -0.59, 0.26}, {-1.08, -0.8, 0.77}, {-1.46, -1.79, 0.83}};
    for (int i = 0; i < 4; ++i) add(to_a_ball, i - 1, places[i], radii[i]);
    // Two bends so near to each other that their rings meet in the middle.
    const std::array<Vec3, 4> turns{Vec3(-3, 0, 0), {0, 0, 0}, {0, 1, 0}, {-3, 1, 0}};
    for (const Document& d : {to_a_ball, chain(turns, 0.45)}) {
        const QuadMesh mesh = placed(Stages(d));
        EXPECT_TRUE(find_self_intersections(mesh)->empty());
        EXPECT_GT(measure(mesh).quad_quality.min, 0);
    }
}

}  // namespace
}  // namespace sinew::sqm
