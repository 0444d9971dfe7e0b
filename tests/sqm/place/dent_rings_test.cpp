#include "sinew/sqm/place/dent_rings.h"

#include "sinew/mesh/intersect.h"
#include "sinew/sqm/surface/dents.h"
#include "sqm/stages.h"

namespace sinew::sqm {
namespace {

/// A ball of radius 1 with its dents, placed but not made symmetric.
struct Dented {
    Stages s;
    Bridge b;
    explicit Dented(const std::vector<double>& angles) : Dented(dented_ball(angles, 0.3, 0.2)) {}
    explicit Dented(const Document& document) : s(document), b(bridge(s.parts()).value()) {
        place(s.parts(), {}, b);
    }

    /// The rings down the dent that a path ends in: indices of stations.
    std::vector<std::int32_t> rings(std::int32_t path) const {
        std::vector<std::int32_t> rings;
        for (std::int32_t i = s.stations.first[path]; i < s.stations.first[path + 1]; ++i)
            if (s.stations.stations[i].shape == RingShape::pit) rings.push_back(i);
        return rings;
    }
    const Station& ring(std::int32_t i) const { return s.stations.stations[i]; }
    const PathEnd& joint(std::int32_t path) const {
        return s.network.path_end[path][ring(rings(path)[0]).far ? 1 : 0];
    }
    const PitShape& pit(std::int32_t path) const {
        return s.surfaces.pits[s.surfaces.extra[s.network.slot_first[0] + joint(path).slot]];
    }
    std::vector<Vec3> vertices(std::int32_t path, std::int32_t ring) const {
        const std::uint32_t first = first_of_ring(s.parts(), b, path, ring);
        std::vector<Vec3> at;
        for (std::int32_t k = 0; k < s.refinement.path_sides[path]; ++k)
            at.push_back(b.mesh.positions[first + k].cast<double>());
        return at;
    }
    /// Where the columns of a path end, at the ring of its joint.
    std::vector<Vec3> border(std::int32_t path) const {
        std::vector<std::uint32_t> ring_of_joint;
        joint_ring_of_path(s.parts(), path, ring(rings(path)[0]).far ? 1 : 0, ring_of_joint);
        std::vector<Vec3> at;
        for (const std::uint32_t v : ring_of_joint) at.push_back(s.points.position[v]);
        return at;
    }
    bool sunk(const Vec3& place) const { return in_dent(s.network, s.surfaces, 0, Vec3::Zero(), place); }
    /// visit(path, ring) for all rings of all dents.
    template <class Visit>
    void for_rings(Visit visit) const {
        int count = 0;
        for (std::int32_t p = 0; p < s.network.path_count(); ++p)
            for (const std::int32_t i : rings(p)) visit(p, i), ++count;
        EXPECT_GT(count, 0);
    }
};

double azimuth(const PitShape& pit, const Vec3& at) { return std::atan2(at.dot(pit.y), at.dot(pit.x)); }

TEST(DentRings, OfALoneDentAreTheOpeningAsDrawnAndItsWall) {
    const Dented d(std::vector<double>{0});
    d.for_rings([&](std::int32_t p, std::int32_t i) {
        const PitShape& pit = d.pit(p);
        for (const Vec3& at : d.vertices(p, i)) {
            if (d.ring(i).share == 1) {  // on the ball, over the rim that was drawn
                EXPECT_NEAR(at.norm(), 1, 1e-5);
                EXPECT_NEAR(Vec2(at.dot(pit.x), at.dot(pit.y)).norm(), 0.3, 0.01);
            } else {
                EXPECT_NEAR(pit.local(at - pit.middle).norm(), 1, 1e-4);
                EXPECT_TRUE(d.sunk(at));
            }
        }
    });
}

/// Rays from the joint's centre cannot tell the floor of a dent that goes past it.
TEST(DentRings, OfADentPastTheCentreAreOnItsWallAllTheSame) {
    const Dented d(dented_ball(std::vector<double>{0}, 0.3, 1.2));
    d.for_rings([&](std::int32_t p, std::int32_t i) {
        const PitShape& pit = d.pit(p);
        ASSERT_NEAR(pit.half.z(), 1.2, 1e-9);
        for (const Vec3& at : d.vertices(p, i))
            if (d.ring(i).share < 1) {
                EXPECT_NEAR(pit.local(at - pit.middle).norm(), 1, 0.02);
            }
    });
}

TEST(DentRings, WhereDentsOverlapHaveTheirRimOnTheSurfaceAndAllElseOnTheFloor) {
    for (const double angle : {0.3, 0.4, 0.5}) {
        const Dented d({-angle / 2, angle / 2});
        ASSERT_TRUE(has_groove(d.s.surfaces, 0));
        int on_rims = 0;
        d.for_rings([&](std::int32_t p, std::int32_t i) {
            const std::vector<Vec3> border = d.border(p), ring = d.vertices(p, i);
            for (std::size_t k = 0; k < ring.size(); ++k) {
                if (d.ring(i).share == 1 && !d.sunk(border[k])) {
                    EXPECT_NEAR(ring[k].norm(), 1, 1e-6);
                    EXPECT_TRUE(on_rim(d.s.network, d.s.surfaces, 0, Vec3::Zero(), ring[k]));
                    ++on_rims;
                } else {
                    EXPECT_TRUE(d.sunk(ring[k])) << i << ' ' << k;
                    EXPECT_TRUE(nearest_wall(d.s.surfaces, 0, ring[k]).touches);
                }
            }
        });
        EXPECT_GT(on_rims, 10);
    }
}

TEST(DentRings, RunRoundTheDentInOrderWhereverItIsOverlapped) {
    for (const std::vector<double>& angles :
         {std::vector<double>{0}, {-0.2, 0.2}, {-0.25, 0.25}, {-0.45, 0, 0.45}}) {
        const Dented d(angles);
        d.for_rings([&](std::int32_t p, std::int32_t i) {
            const double sense = d.ring(i).far ? -1 : 1;
            const std::vector<Vec3> ring = d.vertices(p, i);
            double whole = 0;
            for (std::size_t k = 0; k < ring.size(); ++k) {
                const double turn = std::remainder(
                    azimuth(d.pit(p), ring[(k + 1) % ring.size()]) - azimuth(d.pit(p), ring[k]), 2 * M_PI);
                EXPECT_GT(sense * turn, 0) << angles.size() << ' ' << i << ' ' << k;
                whole += turn;
            }
            EXPECT_NEAR(whole, sense * 2 * M_PI, 1e-9);
        });
        EXPECT_TRUE(find_self_intersections(d.b.mesh)->empty());
    }
}

/// Two equal dents are the same on both sides of the plane through their middles.
TEST(DentRings, AreAsTheMirrorOfTheirDentsHasThem) {
    for (const double angle : {0.3, 0.4, 0.5}) {
        const Dented d({-angle / 2, angle / 2});
        d.for_rings([&](std::int32_t p, std::int32_t i) {
            const std::vector<Vec3> ring = d.vertices(p, i);
            for (const Vec3& at : ring) {
                double nearest = 1;
                for (const Vec3& other : ring)
                    nearest = std::min(nearest, (Vec3(at.x(), -at.y(), at.z()) - other).norm());
                EXPECT_LT(nearest, 1e-3) << angle << ' ' << i;
            }
        });
    }
}

/// A dent that two others overlap, which leave its rim less room between them than beyond: where its columns
/// cross the groove to one of those, how far they stay from the cell's border goes evenly from what it is at
/// the one rim to what it is at the other.
TEST(DentRings, CrossAGrooveEvenlyFromRimToRim) {
    Document document = dented_ball(std::vector<double>{0, 0.45}, 0.3, 0.2);
    document.nodes[add(document, 0, 1.2 * Vec3(-0.1 * std::sin(0.45), std::sin(0.45), std::cos(0.45)), 0.3)]
        .type = NodeType::negative;
    const Dented d(document);
    int uneven = 0;
    for (std::int32_t p = 0; p < d.s.network.path_count(); ++p) {
        if (d.rings(p).empty()) continue;
        std::vector<Vec3> border = d.border(p), widest;
        for (const std::int32_t i : d.rings(p))
            if (d.ring(i).share == 1) widest = d.vertices(p, i);
        const std::size_t n = border.size();
        const auto apart = [&](std::size_t k) {
            return (widest[k % n].normalized() - border[k % n].normalized()).norm();
        };
        for (std::size_t k = 0; k < n; ++k) {
            if (d.sunk(border[k]) || !d.sunk(border[(k + 1) % n])) continue;
            std::size_t end = k + 1;
            while (d.sunk(border[end % n])) ++end;
            const double change = apart(end) - apart(k);
            if (std::abs(change) < 0.02) continue;
            ++uneven;
            for (std::size_t i = k + 1; i + 1 < end; ++i)
                EXPECT_GT((apart(i + 1) - apart(i)) / change, 0) << p << ' ' << i;
        }
    }
    EXPECT_GT(uneven, 0);
}

TEST(DentRings, HaveTheirBottomOnTheFloor) {
    const Dented d(std::vector<double>{0});
    d.for_rings([&](std::int32_t p, std::int32_t) {
        EXPECT_TRUE(bottom_of_dent(d.s.parts(), d.joint(p)).isApprox(Vec3(0, 0, 0.8), 1e-9));
    });
}

}  // namespace
}  // namespace sinew::sqm
