/// Whose radii a fitted and subdivided skin has: those of the skeleton.
#include <gtest/gtest.h>

#include <cmath>

#include "extend/skinning.h"
#include "sinew/sqm/skin.h"
#include "sinew/subdivide/subdivide.h"

namespace sinew {
namespace {

/// A stick along x from 0 to `length`, of radius 1, with nodes evenly between its ends.
Document stick(double length, int between, NodeType ends) {
    Document document;
    for (int i = 0; i < between + 2; ++i)
        testing_types::add(document, i - 1, {length * i / (between + 1), 0, 0}, 1,
                           i == 0 || i == between + 1 ? ends : NodeType::sphere);
    return document;
}

std::vector<Vec3f> smooth_points(const Document& document, int sides) {
    const auto skinned = skin(document, {.sides = sides, .fit = Fit::limit});
    EXPECT_TRUE(skinned) << skinned.error().text();
    return subdivide(skinned->mesh, {.levels = 3, .limit = true})->positions;
}

/// Largest deviation from the radius of a tube along x between two heights, of points below a plane.
double worst_between(const std::vector<Vec3f>& points, double low, double high, double top = 1e9) {
    double worst = 0;
    int seen = 0;
    for (const Vec3f& p : points)
        if (p.x() >= low && p.x() <= high && p.z() < top) {
            worst = std::max(worst, std::abs(std::hypot(p.y(), p.z()) - 1.0));
            ++seen;
        }
    EXPECT_GT(seen, 0);
    return worst;
}
double worst_of_capsule(const std::vector<Vec3f>& points, double length) {
    double worst = 0;
    for (const Vec3f& p : points) {
        const double beyond = p.x() - std::clamp(static_cast<double>(p.x()), 0.0, length);
        worst = std::max(worst, std::abs(Vec3(beyond, p.y(), p.z()).norm() - 1));
    }
    return worst;
}

/// What a smooth ring of so many points is out of round by, at the best.
double out_of_round(int sides) { return sides == 4 ? 0.015 : 0.005; }

TEST(SkinnedRadii, OfTubesWithFlatEnds) {
    for (const int sides : {4, 5, 6, 8, 12})
        for (const double length : {1.0, 3.0, 10.0})
            for (const int between : {0, 1, 3}) {
                SCOPED_TRACE(testing::Message() << sides << " sides, length " << length << ", " << between);
                const auto points = smooth_points(stick(length, between, NodeType::hemisphere), sides);
                EXPECT_LT(worst_between(points, 0.01, length - 0.01), out_of_round(sides));
            }
}

TEST(SkinnedRadii, OfTubesBetweenRoundEnds) {
    for (const int sides : {4, 5, 6, 8, 12})
        for (const int between : {0, 1, 3, 7}) {
            SCOPED_TRACE(testing::Message() << sides << " sides, " << between << " nodes between");
            const auto points = smooth_points(stick(10, between, NodeType::sphere), sides);
            EXPECT_LT(worst_between(points, 1.2, 8.8), out_of_round(sides));
            EXPECT_LT(worst_of_capsule(points, 10), out_of_round(sides) + (sides < 6 ? 0.014 : 0.008));
        }
}

TEST(SkinnedRadii, OfShortSticks) {
    for (const int sides : {4, 5, 6, 8})
        for (const double length : {0.3, 0.6, 1.0, 1.5, 2.0, 3.0}) {
            SCOPED_TRACE(testing::Message() << sides << " sides, length " << length);
            const auto points = smooth_points(stick(length, 0, NodeType::sphere), sides);
            EXPECT_LT(worst_of_capsule(points, length), length < 1 ? 0.055 : 0.03);
        }
}

TEST(SkinnedRadii, OfAFrameWithSharpBends) {
    // A square of bones stays one: its arms are straight tubes up to an edge or two from the corners.
    Document frame;
    for (int i = 0; i < 4; ++i)
        testing_types::add(frame, i - 1, {i == 1 || i == 2 ? 10.0 : 0.0, 0, i >= 2 ? 10.0 : 0.0}, 1);
    frame.links = {{3, 0}};
    for (const int sides : {4, 5, 6, 8}) {
        SCOPED_TRACE(sides);
        EXPECT_LT(worst_between(smooth_points(frame, sides), 3.2, 6.8, 5), out_of_round(sides));
    }
}

TEST(SkinnedRadii, OfALimbBehindWhatStandsOnIt) {
    for (const NodeType type : {NodeType::sphere, NodeType::negative})
        for (const int sides : {6, 8, 12, 16}) {
            SCOPED_TRACE(testing::Message() << (type == NodeType::negative ? "dent, " : "branch, ") << sides);
            Document limb = stick(6, 1, NodeType::hemisphere);
            testing_types::add(limb, 1, {3, 0, type == NodeType::negative ? 1.4 : 2.0}, 0.4, type);
            // No tighter: a joint's faces are as long as the limb is wide.
            EXPECT_LT(worst_between(smooth_points(limb, sides), 0.5, 5.5, 0.4), sides > 8 ? 0.04 : 0.025);
        }
}

}  // namespace
}  // namespace sinew
