#include "sinew/sqm/surface/crowded_slots.h"

#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

/// Cones of every sort from one ball: thin and thick, narrowing, growing, and balls inside others.
std::vector<ConeFrom> random_cones(property::Random& random, int count, double spread) {
    std::vector<ConeFrom> cones;
    for (int i = 0; i < count; ++i) {
        const Vec3 axis = (Vec3::UnitX() + spread * random.direction()).normalized();
        cones.emplace_back(Vec3::Zero(), 1, random.between(0.1, 6) * axis, random.between(0.01, 3));
    }
    return cones;
}

TEST(CrowdedSlots, AnswerAsASearchThroughAllDoes) {
    property::Random random(3);
    for (const double spread : {0.0, 1e-3, 0.3, 100.0}) {
        const std::vector<ConeFrom> cones = random_cones(random, 400, spread);
        std::vector<double> limits;
        for (const ConeFrom& cone : cones) limits.push_back(random.between(0.5, 1) * cone.length);
        CrowdedSlots crowd(cones);
        crowd.set_limits(limits);
        for (int i = 0; i < 200; ++i) {
            const Vec3 ray = i % 2 == 0 ? random.direction() : cones[random.below(400)].axis;
            double exit = 0;
            for (const ConeFrom& cone : cones) exit = std::max(exit, cone.exit(ray));
            EXPECT_EQ(crowd.exit(cones, ray), exit);
            double limited = exit;
            for (std::size_t s = 0; s < cones.size(); ++s)
                if (const double along = ray.dot(cones[s].axis); along > 0)
                    limited = std::min(limited, limits[s] / along);
            EXPECT_NEAR(crowd.limited(cones, limits, ray, exit), limited, 1e-12 * exit);
        }
        for (int slot = 0; slot < 400; slot += 7) {
            double nearest = -1;
            for (int other = 0; other < 400; ++other)
                if (other != slot) nearest = std::max(nearest, cones[slot].axis.dot(cones[other].axis));
            EXPECT_NEAR(crowd.nearest_cosine(cones, slot), nearest, 1e-11);
        }
    }
}

}  // namespace
}  // namespace sinew::sqm
