#include "sinew/mesh/predicates.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sinew {
namespace {

constexpr double epsilon = 0x1p-53;

int sign_of(double value) { return (value > 0) - (value < 0); }

/// An exact sum of doubles: components that do not overlap, in ascending order of magnitude, none of them
/// zero.
template <std::size_t most>
class ExactSum {
  public:
    void add(double value) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < size_; ++i) {
            const double sum = value + components_[i];
            const double other = sum - value;
            const double rounding = (value - (sum - other)) + (components_[i] - other);
            value = sum;
            if (rounding != 0) components_[kept++] = rounding;
        }
        if (value != 0) components_[kept++] = value;
        size_ = kept;
    }
    int sign() const { return size_ == 0 ? 0 : sign_of(components_[size_ - 1]); }

  private:
    std::array<double, most> components_;
    std::size_t size_ = 0;
};

using Sum3d = ExactSum<48>;

/// Adds x y z for three floats: the product of two fits into a double, and each half of it times the third as
/// well.
void add_product(Sum3d& sum, double x, double y, double z) {
    const double xy = x * y;
    const double shifted = xy * (0x1p27 + 1);
    const double high = shifted - (shifted - xy);
    sum.add(high * z);
    sum.add((xy - high) * z);
}

/// Adds sign * (a . (b x c)).
void add_triple(Sum3d& sum, double sign, const Vec3& a, const Vec3& b, const Vec3& c) {
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        add_product(sum, sign * a[i], b[j], c[k]);
        add_product(sum, -sign * a[i], b[k], c[j]);
    }
}

int exact_orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    Sum3d sum;
    add_triple(sum, 1, a, b, c);
    add_triple(sum, -1, b, c, d);
    add_triple(sum, 1, a, c, d);
    add_triple(sum, -1, a, b, d);
    return sum.sign();
}

}  // namespace

int orient3d(const Vec3f& af, const Vec3f& bf, const Vec3f& cf, const Vec3f& df) {
    const Vec3 d = df.cast<double>();
    const Vec3 a = af.cast<double>() - d, b = bf.cast<double>() - d, c = cf.cast<double>() - d;
    const double bcx = b.y() * c.z(), cbx = b.z() * c.y();
    const double bcy = b.z() * c.x(), cby = b.x() * c.z();
    const double bcz = b.x() * c.y(), cbz = b.y() * c.x();
    const double det = a.x() * (bcx - cbx) + a.y() * (bcy - cby) + a.z() * (bcz - cbz);
    const double size = std::abs(a.x()) * (std::abs(bcx) + std::abs(cbx)) +
                        std::abs(a.y()) * (std::abs(bcy) + std::abs(cby)) +
                        std::abs(a.z()) * (std::abs(bcz) + std::abs(cbz));
    if (size == 0) return 0;
    if (std::abs(det) > (7 + 56 * epsilon) * epsilon * size) return sign_of(det);
    return exact_orient3d(af.cast<double>(), bf.cast<double>(), cf.cast<double>(), d);
}

int orient2d(const Vec3f& a, const Vec3f& b, const Vec3f& c, int axis) {
    const int x = axis == 2 ? 0 : axis + 1, y = axis == 0 ? 2 : axis - 1;
    const double ax = a[x], ay = a[y], bx = b[x], by = b[y], cx = c[x], cy = c[y];
    const double left = (ax - cx) * (by - cy), right = (ay - cy) * (bx - cx);
    const double det = left - right, size = std::abs(left) + std::abs(right);
    if (size == 0) return 0;
    if (std::abs(det) > (3 + 16 * epsilon) * epsilon * size) return sign_of(det);
    ExactSum<6> sum;
    for (const double product : {ax * by, -ax * cy, cx * ay, -bx * ay, bx * cy, -cx * by}) sum.add(product);
    return sum.sign();
}

int projection_axis(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    const Vec3 normal = (b - a).cast<double>().cross((c - a).cast<double>());
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    for (int i = 0; i < 3; ++i, axis = (axis + 1) % 3)
        if (orient2d(a, b, c, axis) != 0) return axis;
    return -1;
}

}  // namespace sinew
