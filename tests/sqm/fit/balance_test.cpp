#include "sinew/sqm/fit/balance.h"

#include "sinew/mesh/limit.h"
#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

/// A joint of three tubes, placed; the vertices of the joint are balanced.
struct Placed {
    Stages stages{star(fan(3), 6, 0.5)};
    Bridge bridge{sinew::sqm::bridge(stages.parts()).value()};
    Parts parts{stages.parts()};
    std::vector<Vec3> positions;

    Placed() {
        finish(stages, false, bridge);
        for (const Vec3f& at : bridge.mesh.positions) positions.push_back(at.cast<double>());
    }
    std::vector<std::int32_t> joint() const {
        std::vector<std::int32_t> joint(positions.size(), -1);
        std::fill_n(joint.begin(), stages.points.position.size(), 0);
        return joint;
    }
};

TEST(Balance, IsOfTheVerticesThatAreAskedFor) {
    const Placed p;
    const Balance balance(p.parts, p.bridge.mesh, p.joint());
    for (std::size_t v = 0; v < p.positions.size(); ++v)
        EXPECT_EQ(balance.balances(v), v < p.stages.points.position.size());
}

/// Of a surface that is the ideal one moved out everywhere, and of one that was moved in.
TEST(Balance, SaysHowFarASurfaceIsOutside) {
    Placed p;
    Balance balance(p.parts, p.bridge.mesh, p.joint());
    for (const double scale : {3.0, 0.2}) {
        std::vector<Vec3> moved;
        for (const Vec3& at : p.positions) moved.push_back(scale * at);
        balance.measure(moved, moved);
        for (std::size_t v = 0; v < p.stages.points.position.size(); ++v) {
            const double mean = balance.mean_outside(v, moved[v]);
            if (scale > 1)
                EXPECT_GT(mean, 0);
            else
                EXPECT_LT(mean, 0);
        }
    }
}

/// What is outside weighs more: as much outside as inside is too far out.
TEST(Balance, MindsSwellingsMoreThanHollows) {
    Placed p;
    Balance balance(p.parts, p.bridge.mesh, p.joint());
    balance.measure(p.positions, p.positions);
    const Vec3& at = p.positions[0];
    const Vec3 ray = at.normalized();
    const double base = balance.mean_outside(0, at), out = balance.mean_outside(0, at + 0.1 * ray),
                 in = balance.mean_outside(0, at - 0.1 * ray);
    EXPECT_GT(out - base, base - in);
}

}  // namespace
}  // namespace sinew::sqm
