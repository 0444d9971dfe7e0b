#include "sinew/mesh/predicates.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

namespace sinew {
namespace {

using Int3 = Eigen::Matrix<std::int64_t, 3, 1>;

int sign_of(std::int64_t value) { return (value > 0) - (value < 0); }

/// Points with whole coordinates, which fit into a float and their determinants into 64 bits.
class Whole {
  public:
    explicit Whole(int most) : most_(most) {}
    Int3 point() {
        std::uniform_int_distribution<int> coordinate(-most_, most_);
        return {coordinate(random_), coordinate(random_), coordinate(random_)};
    }
    int most_;
    std::mt19937 random_{1};
};

Vec3f as_float(const Int3& p) { return p.cast<float>(); }

TEST(Predicates, Orient3dIsTheSignOfTheDeterminant) {
    for (const int most : {1, 3, 100, 1 << 18}) {
        Whole whole(most);
        for (int i = 0; i < 5000; ++i) {
            const Int3 a = whole.point(), b = whole.point(), c = whole.point(), d = whole.point();
            ASSERT_EQ(orient3d(as_float(a), as_float(b), as_float(c), as_float(d)),
                      sign_of((a - d).dot((b - d).cross(c - d))));
        }
    }
}

TEST(Predicates, NearlyCoplanarPointsAreToldApart) {
    // d lies on the plane of the others, or one step of the last bit beside it.
    Whole whole(1 << 16);
    for (int i = 0; i < 5000; ++i) {
        const Int3 a = whole.point(), b = whole.point(), c = whole.point(), d = a + b - c;
        const std::int64_t above = (a - b).cross(c - b).x();
        const Int3 next = d + Int3(1, 0, 0);
        ASSERT_EQ(orient3d(as_float(a), as_float(b), as_float(c), as_float(d)), 0);
        ASSERT_EQ(orient3d(as_float(a), as_float(b), as_float(c), as_float(next)),
                  sign_of((a - next).dot((b - next).cross(c - next))));
        ASSERT_EQ(std::abs(orient3d(as_float(a), as_float(b), as_float(c), as_float(next))), above != 0);
    }
}

TEST(Predicates, NoScaleIsTooLargeOrTooSmall) {
    Whole whole(50);
    for (int i = 0; i < 5000; ++i) {
        const Vec3f a = as_float(whole.point()), b = as_float(whole.point()), c = as_float(whole.point());
        const Vec3f d = as_float(whole.point());
        for (const float scale : {0x1p-120f, 0x1p100f})
            ASSERT_EQ(orient3d(scale * a, scale * b, scale * c, scale * d), orient3d(a, b, c, d));
        // Differences of these need more than 53 bits.
        const Vec3f far(0x1p60f, -0x1p60f, 0x1p60f);
        ASSERT_EQ(orient3d(a, b, far, Vec3f(0, 0, 0)),
                  sign_of(std::int64_t(a.cross(b).dot(Vec3f(1, -1, 1)))));
    }
}

TEST(Predicates, Orient2dIsTheSignOfTheArea) {
    for (const int most : {1, 4, 1000, 1 << 22}) {
        Whole whole(most);
        for (int i = 0; i < 5000; ++i) {
            const Int3 a = whole.point(), b = whole.point(), c = whole.point();
            const Int3 normal = (b - a).cross(c - a);
            for (int axis = 0; axis < 3; ++axis)
                ASSERT_EQ(orient2d(as_float(a), as_float(b), as_float(c), axis), sign_of(normal[axis]));
            const int axis = projection_axis(as_float(a), as_float(b), as_float(c));
            ASSERT_EQ(axis >= 0, normal != Int3::Zero());
            if (axis >= 0) {
                ASSERT_NE(normal[axis], 0);
            }
        }
    }
}

}  // namespace
}  // namespace sinew
