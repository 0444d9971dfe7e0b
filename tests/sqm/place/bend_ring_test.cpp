#include "sinew/sqm/place/bend_ring.h"

#include "sinew/mesh/intersect.h"
#include "sinew/sqm/skin.h"
#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

/// A bone of radii 1 and `before` that comes along x, and one of radii 1 and `after` that turns up from the
/// origin.
struct Bend {
    ConeFrom before, after;
    Station station;

    Bend(double far_before, double far_after, double turn)
        : before({0, 0, 0}, 1, {-9, 0, 0}, far_before),
          after({0, 0, 0}, 1, 6 * Vec3(std::cos(turn), std::sin(turn), 0), far_after) {
        station.tangent = (after.axis - before.axis).normalized();
    }
    BendRing ring(double room = 100) const {
        BendRing ring(station, before, after);
        ring.give_room(room, room);
        return ring;
    }
    /// In the ring's plane, at this angle from the inner side of the bend.
    Vec3 ray(double angle) const {
        const Vec3 inner = (after.axis + before.axis).normalized();
        return std::cos(angle) * inner + std::sin(angle) * Vec3::UnitZ();
    }
};

/// How far outside a cone a place is.
double outside(const ConeFrom& cone, const Vec3& place) {
    return place.norm() - cone.exit(place.normalized());
}

TEST(BendRing, LiesOnBothConesOnTheInnerSide) {
    for (const double turn : {0.4, 0.9, 1.5, 2.0})
        for (const auto& [before, after] : {std::pair(1.0, 1.0), {1.9, 0.8}, {0.7, 1.4}, {1.5, 1.6}}) {
            const Bend bend(before, after, turn);
            for (const double angle : {-0.5, -0.2, 0.0, 0.3, 0.5}) {
                const Vec3 place = bend.ring().at(bend.ray(angle));
                EXPECT_NEAR(outside(bend.before, place), 0, 1e-3);
                EXPECT_NEAR(outside(bend.after, place), 0, 1e-3);
            }
        }
}

TEST(BendRing, LiesOnTheBallOnTheOuterSide) {
    const Bend bend(0.5, 0.8, 1.0);
    for (const double angle : {2.6, M_PI, 3.6}) EXPECT_NEAR(bend.ring().at(bend.ray(angle)).norm(), 1, 1e-12);
}

TEST(BendRing, LeansNoFurtherThanItsRoom) {
    for (const double far : {1.0, 1.6}) {
        const Bend bend(far, 1, 2.2);
        const Vec3 place = bend.ring(0.7).at(bend.ray(0));
        EXPECT_LE(place.dot(bend.before.axis), 0.7 + 1e-12);
        EXPECT_LE(place.dot(bend.after.axis), 0.7 + 1e-12);
    }
}

/// Two bends in a row whose planes lean towards each other: on every line along the bone between them, the
/// plane of the one must come before that of the other.
TEST(BendRing, StaysWhereThePlaneOfTheNextBendIsBeyondItsOwn) {
    int reached = 0;
    for (const double length : {1.2, 2.0, 3.0})
        for (const double far_before : {0.2, 1.0, 1.9})
            for (const double turn : {0.6, 1.2, 1.8}) {
                const Vec3 axis(std::cos(turn), std::sin(turn), 0);
                const ConeFrom before({0, 0, 0}, 1, {-9, 0, 0}, far_before),
                    after({0, 0, 0}, 1, length * axis, 1);
                Station here, next;
                here.tangent = (after.axis - before.axis).normalized();
                next.tangent = (axis + Vec3(std::cos(2 * turn), std::sin(2 * turn), 0)).normalized();
                BendRing ring(here, before, after);
                ring.give_room(100, 100);
                ring.keep_from(next, false);
                const Vec3 inner = Vec3::UnitZ().cross(here.tangent);
                for (double angle = -1.5; angle < 1.5; angle += 0.1) {
                    const Vec3 at = ring.at(std::cos(angle) * inner + std::sin(angle) * Vec3::UnitZ());
                    const double own = -here.tangent.dot(at) / here.tangent.dot(axis),
                                 beyond = length - next.tangent.dot(at) / next.tangent.dot(axis);
                    EXPECT_GE(beyond - own, 0.02 * length - 1e-9)
                        << length << ' ' << far_before << ' ' << turn;
                    reached += beyond - own < 0.02 * length + 1e-9;
                }
            }
    EXPECT_GT(reached, 0) << "some vertex is held back";
}

/// Such a plane is not crossed by going along the bone.
TEST(BendRing, TakesNoHeedOfAPlaneAlongTheBone) {
    const Bend bend(1, 1, 1.2);
    Station next;
    next.tangent = (Vec3::UnitZ().cross(bend.after.axis) + 1e-5 * bend.after.axis).normalized();
    BendRing ring = bend.ring();
    ring.keep_from(next, false);
    for (double angle = 0; angle < 6; angle += 0.3)
        EXPECT_EQ(ring.at(bend.ray(angle)), bend.ring().at(bend.ray(angle)));
}

TEST(BendRing, FacesOnBothSidesStayWithinTheirCones) {
    // a thin bone turns back beside a wide one
    const std::vector<Ball> balls{{-1, {0, 0, 0}, 1}, {0, {4, 0, 0}, 0.4}, {1, {2.8, 2.6, 0}, 0.4}};
    const auto skin = sinew::skin(tree(balls));
    ASSERT_TRUE(skin);
    const QuadMesh& mesh = skin->mesh;
    const ConeFrom wide({0, 0, 0}, 1, {4, 0, 0}, 0.4), thin({4, 0, 0}, 0.4, {2.8, 2.6, 0}, 0.4);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        double of_wide = 0, of_thin = 0;
        for (const std::uint32_t v : mesh.face(f)) {
            const Vec3 place = mesh.positions[v].cast<double>();
            of_wide = std::max(of_wide, outside(wide, place));
            of_thin = std::max(of_thin, outside(thin, place - Vec3(4, 0, 0)));
        }
        EXPECT_LT(std::min(of_wide, of_thin), 1e-3);
    }
}

/// The middle planes of a triangle's bones meet outside it, or on its longest side.
TEST(BendRing, RingsOfTrianglesWithoutAHoleDoNotCross) {
    for (const Vec3& tip : {Vec3(0, 1, 0), Vec3(-0.4, 0.8, 0), Vec3(0.5, 0.3, 0), Vec3(0.5, 0.9, 0)}) {
        Document d = chain(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, tip}, 1.5);
        d.links = {{2, 0}};
        const auto skin = sinew::skin(d);
        ASSERT_TRUE(skin);
        EXPECT_TRUE(find_self_intersections(skin->mesh)->empty());
    }
}

}  // namespace
}  // namespace sinew::sqm
