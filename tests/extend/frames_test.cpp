#include "sinew/extend/frames.h"

#include "skinning.h"

namespace sinew {
namespace {

TEST(Frames, AreRightHandedUnitAndLeadAlongZ) {
    for (const Vec3& z : {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(-0.95, 0.1, 0.2), Vec3(0.3, -0.4, 0.5)}) {
        const Frame f = frame_along(z.normalized(), 33);
        EXPECT_LT((f.z - z.normalized()).norm(), 1e-12);
        EXPECT_LT((f.x.cross(f.y) - f.z).norm(), 1e-12);
        EXPECT_NEAR(f.x.dot(f.z), 0, 1e-12);
    }
}

TEST(Frames, TakeTheWorldsXOrNearItTheWorldsY) {
    EXPECT_EQ(frame_along(Vec3::UnitZ(), 0).x, Vec3(Vec3::UnitX()));
    EXPECT_EQ(frame_along(Vec3::UnitX(), 0).x, Vec3(Vec3::UnitY()));
}

TEST(Frames, RollExactlyByQuarterAndEighthTurns) {
    EXPECT_EQ(frame_along(Vec3::UnitZ(), 90).x, Vec3(Vec3::UnitY()));
    EXPECT_EQ(frame_along(Vec3::UnitZ(), -270).x, Vec3(Vec3::UnitY()));
    const Vec3 x = frame_along(Vec3::UnitZ(), 45).x;
    EXPECT_EQ(x.x(), x.y());
}

TEST(Frames, TurnWithTheLeastRotation) {
    const Frame f = turn_frame(frame_along(Vec3::UnitZ(), 0), Vec3::UnitX());
    EXPECT_LT((f.y - Vec3::UnitY()).norm(), 1e-12);  // the axis of the turn stays
    EXPECT_LT((f.x + Vec3::UnitZ()).norm(), 1e-12);
}

}  // namespace
}  // namespace sinew
