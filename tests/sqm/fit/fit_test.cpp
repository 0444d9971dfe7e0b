#include "sinew/sqm/fit/fit.h"

#include "sinew/mesh/deviation.h"
#include "sinew/mesh/limit.h"
#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

QuadMesh fitted(const Stages& s) {
    Bridge b = bridge(s.parts()).value();
    finish(s, true, b);
    return b.mesh;
}

TEST(Fit, TheSmoothTubeHasTheRadius) {
    for (const int sides : {4, 6, 8}) {
        const Stages s(chain(std::vector<Vec3>{{0, 0, 0}, {4, 0, 0}, {8, 0, 0}, {12, 0, 0}}, 0.5), sides);
        const QuadMesh mesh = fitted(s);
        const std::vector<Vec3f> limit = limit_positions(mesh).value();
        // A cubic through n points of a circle runs as far inside it between them as it may lie outside.
        const double outside = 0.5 * (ring_fit_radius(sides) - 1);
        for (std::size_t v = 0; v < limit.size(); ++v) {
            if (limit[v].x() < 1 || limit[v].x() > 11) continue;
            EXPECT_NEAR(std::hypot(limit[v].y(), limit[v].z()), 0.5 + outside, 0.005) << sides;
            EXPECT_GT(std::hypot(mesh.positions[v].y(), mesh.positions[v].z()), 0.5);
        }
    }
}

/// Of the smooth surface from the skeleton's round cones.
Deviation limit_deviation(QuadMesh mesh, const Plain& skeleton) {
    RoundCones cones;
    for (const auto& [a, b] : skeleton.bones)
        cones.add(skeleton.position[a], skeleton.radius[a], skeleton.position[b], skeleton.radius[b]);
    mesh.positions = limit_positions(mesh).value();
    return measure_deviation(mesh, cones);
}

TEST(Fit, BringsTheSmoothSurfaceOfJointsToTheRoundCones) {
    property::Random random(25);
    for (int degree = 3; degree < 9; ++degree) {
        const Stages s(star(random_directions(random, degree), 6, 0.5));
        Bridge plain = bridge(s.parts()).value();
        finish(s, false, plain);
        const double fit = limit_deviation(fitted(s), s.skeleton).mean_abs;
        EXPECT_LT(fit, 0.15) << degree;  // narrow angles are the worst: a crease cannot be smooth
        EXPECT_LT(fit, 0.5 * limit_deviation(plain.mesh, s.skeleton).mean_abs) << degree;
    }
}

TEST(Fit, IsCloseWhereBonesAreWideApart) {
    for (const auto& directions : {fan(3), fan(4)}) {
        const Stages s(star(directions, 6, 0.5));
        EXPECT_LT(limit_deviation(fitted(s), s.skeleton).mean_abs, 0.03);
    }
}

TEST(Fit, LeavesTipsWhereTheyWerePut) {
    Document d = star(fan(3), 4, 0.5);
    for (std::int32_t i = 1; i <= 3; ++i) d.nodes[i].type = NodeType::cone;
    const Stages s(d);
    const QuadMesh mesh = fitted(s);
    for (std::int32_t i = 1; i <= 3; ++i) {
        float nearest = 1e9f;
        for (const Vec3f& p : mesh.positions)
            nearest = std::min(nearest, (p - d.nodes[i].position.cast<float>()).norm());
        EXPECT_LT(nearest, 1e-5f);
    }
}

}  // namespace
}  // namespace sinew::sqm
