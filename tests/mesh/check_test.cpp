#include "sinew/mesh/check.h"

#include <gtest/gtest.h>

#include <atomic>

#include "mesh/shapes.h"

namespace sinew {
namespace {

TEST(Check, ACleanTubeBesideItsSkeleton) {
    RoundCones cones;
    cones.add({0, 0, 0}, 1, {0, 0, 4}, 1);
    const Result<MeshReport> report = check(shapes::tube(9, 32), {.cones = &cones});
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->clean());
    EXPECT_EQ(report->validation.euler, 2);
    EXPECT_EQ(report->measures.poles, 2);
    ASSERT_TRUE(report->intersections && report->deviation);
    EXPECT_LT(report->deviation->p95_abs, 1e-6);
}

TEST(Check, EachFaultShows) {
    const QuadMesh cube = shapes::cube();
    EXPECT_FALSE(check(shapes::without_faces(cube, {2}))->clean());
    EXPECT_FALSE(check(shapes::with_face_flipped(cube, 2))->clean());
    const QuadMesh crossing = shapes::together(cube, shapes::moved(cube, {0.5f, 0.5f, 0.5f}));
    EXPECT_EQ(check(crossing)->intersections->size(), 6u);
    EXPECT_FALSE(check(crossing)->clean());
    const MeshReport quick = *check(crossing, {.self_intersections = false});
    EXPECT_FALSE(quick.intersections);
    EXPECT_TRUE(quick.clean());
}

TEST(Check, WhatWasNotLookedAtToTheEndIsNotClean) {
    MeshReport report = *check(shapes::cube());
    EXPECT_TRUE(report.clean());
    report.all_intersections = false;
    EXPECT_FALSE(report.clean());
}

TEST(Check, AMeshThatIsNotWellFormedIsLookedAtNoFurther) {
    QuadMesh mesh = shapes::cube();
    mesh.corners[3] = 77;
    const Result<MeshReport> report = check(mesh);
    ASSERT_TRUE(report);
    EXPECT_EQ(report->validation.bad_corners.count, 1);
    EXPECT_FALSE(report->intersections);
    EXPECT_FALSE(report->clean());
}

TEST(Check, StopsOnRequest) {
    const std::atomic<bool> cancel = true;
    EXPECT_EQ(check(shapes::cube(), {}, Progress({}, &cancel)).error().kind, ErrorKind::cancelled);
}

}  // namespace
}  // namespace sinew
