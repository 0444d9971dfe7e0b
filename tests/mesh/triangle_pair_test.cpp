#include "sinew/mesh/triangle_pair.h"

#include <gtest/gtest.h>

#include <random>

#include "sinew/mesh/predicates.h"

namespace sinew {
namespace {

using Int3 = Eigen::Matrix<std::int64_t, 3, 1>;
using Polygon = std::vector<Int3>;

/// Two flat convex polygons are apart if and only if they are so along one of these axes: their normals, the
/// products of their edges, and (for polygons in one plane) their edges turned in the plane. Whole numbers:
/// this is exact.
bool apart_along(const Int3& axis, const Polygon& a, const Polygon& b) {
    auto range = [&](const Polygon& polygon) {
        std::int64_t low = INT64_MAX, high = INT64_MIN;
        for (const Int3& p : polygon) low = std::min(low, p.dot(axis)), high = std::max(high, p.dot(axis));
        return std::pair(low, high);
    };
    return range(a).second < range(b).first || range(b).second < range(a).first;
}

bool polygons_meet(const Polygon& a, const Polygon& b) {
    auto normal = [](const Polygon& p) -> Int3 { return (p[1] - p[0]).cross(p[2] - p[0]); };
    auto edge = [](const Polygon& p, std::size_t i) -> Int3 { return p[(i + 1) % p.size()] - p[i]; };
    if (apart_along(normal(a), a, b) || apart_along(normal(b), a, b)) return false;
    for (const Polygon* p : {&a, &b})
        for (std::size_t i = 0; i < p->size(); ++i)
            if (apart_along(normal(*p).cross(edge(*p, i)), a, b)) return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j)
            if (apart_along(edge(a, i).cross(edge(b, j)), a, b)) return false;
    return true;
}

/// What is left of a triangle when the half next to its first corner is cut off; all coordinates are even.
Polygon far_half(const Polygon& t) { return {(t[0] + t[1]) / 2, t[1], t[2], (t[0] + t[2]) / 2}; }

std::vector<Vec3f> as_floats(const Polygon& points) {
    std::vector<Vec3f> result;
    for (const Int3& p : points) result.push_back(p.cast<float>());
    return result;
}

class TrianglePair : public testing::Test {
  protected:
    Int3 point(int most) {
        std::uniform_int_distribution<int> coordinate(0, most);
        return 2 * Int3(coordinate(random_), coordinate(random_), coordinate(random_));
    }
    static bool flat(const Int3& a, const Int3& b, const Int3& c) {
        return (b - a).cross(c - a) == Int3::Zero();
    }
    std::mt19937 random_{7};
};

TEST_F(TrianglePair, SeparateTrianglesMeetWhereNoAxisPartsThem) {
    int met = 0, tried = 0;
    for (const int most : {2, 3, 6, 1000}) {  // on small grids points often lie on edges and planes
        for (int i = 0; i < 6000; ++i) {
            const Polygon p{point(most), point(most), point(most), point(most), point(most), point(most)};
            if (flat(p[0], p[1], p[2]) || flat(p[3], p[4], p[5])) continue;
            const bool meet = polygons_meet({p[0], p[1], p[2]}, {p[3], p[4], p[5]});
            ASSERT_EQ(triangles_intersect(as_floats(p), {0, 1, 2}, {3, 4, 5}), meet);
            ASSERT_EQ(triangles_intersect(as_floats(p), {4, 3, 5}, {2, 0, 1}), meet);
            met += meet;
            ++tried;
        }
    }
    EXPECT_GT(met, tried / 20);
    EXPECT_LT(met, tried - tried / 20);
}

TEST_F(TrianglePair, TrianglesInOnePlane) {
    for (int i = 0; i < 6000; ++i) {
        Polygon p{point(4), point(4), point(4), point(4), point(4), point(4)};
        for (Int3& q : p) q.z() = q.x() + 2 * q.y();
        if (flat(p[0], p[1], p[2]) || flat(p[3], p[4], p[5])) continue;
        ASSERT_EQ(triangles_intersect(as_floats(p), {0, 1, 2}, {3, 4, 5}),
                  polygons_meet({p[0], p[1], p[2]}, {p[3], p[4], p[5]}));
    }
}

TEST_F(TrianglePair, OneSharedVertexIsNoIntersectionByItself) {
    for (const int most : {2, 3, 8})
        for (int i = 0; i < 6000; ++i) {
            const Polygon p{point(most), point(most), point(most), point(most), point(most)};
            const Polygon a{p[0], p[1], p[2]}, b{p[0], p[3], p[4]};
            if (flat(p[0], p[1], p[2]) || flat(p[0], p[3], p[4])) continue;
            // What they share beyond the vertex reaches to the opposite edge of one, which is in its far
            // half.
            const bool meet = polygons_meet(far_half(a), b) || polygons_meet(a, far_half(b));
            ASSERT_EQ(triangles_intersect(as_floats(p), {0, 1, 2}, {3, 4, 0}), meet);
            ASSERT_EQ(triangles_intersect(as_floats(p), {4, 0, 3}, {2, 0, 1}), meet);
        }
}

TEST_F(TrianglePair, ASharedEdgeIsOneOnlyWhereTheyAreFoldedOntoEachOther) {
    for (int i = 0; i < 6000; ++i) {
        const Polygon p{point(2), point(2), point(2), point(2)};
        if (flat(p[0], p[1], p[2]) || flat(p[0], p[1], p[3])) continue;
        const Int3 m = (p[1] - p[0]).cross(p[2] - p[0]), n = (p[1] - p[0]).cross(p[3] - p[0]);
        const bool folded = m.cross(n) == Int3::Zero() && m.dot(n) > 0;
        ASSERT_EQ(triangles_intersect(as_floats(p), {0, 1, 2}, {1, 0, 3}), folded);
        ASSERT_EQ(triangles_intersect(as_floats(p), {2, 0, 1}, {3, 1, 0}), folded);
    }
}

TEST_F(TrianglePair, TheSameTriangleTwice) {
    const std::vector<Vec3f> p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    EXPECT_TRUE(triangles_intersect(p, {0, 1, 2}, {0, 2, 1}));
}

}  // namespace
}  // namespace sinew
