#include "sinew/sqm/fit/round_end.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sinew::sqm {
namespace {

constexpr int samples = 8;      // of the surface between two rows
constexpr int plain_steps = 3;  // of Gauss and Newton
/// What then is taken of each step that weighs the worst most: first as far as it may swing, at last so far
/// that it comes to rest. Always as many, so that the result is as smooth as what it is made of.
constexpr double weighed_steps[] = {0.7, 0.6, 0.6, 0.5, 0.4, 0.3};
constexpr double least_weight = 1e-2;
constexpr double reluctance = 1e-3;  // of rows to slide along the profile, where nothing else holds them

using Weights = std::array<double, 4>;  // of four rows in a cubic B-spline

constexpr Weights spline_weights(double t) {
    const double s = 1 - t;
    return {s * s * s / 6, ((3 * t - 6) * t * t + 4) / 6, ((3 * s - 6) * s * s + 4) / 6, t * t * t / 6};
}
constexpr std::array<Weights, samples> weights_of_samples() {
    std::array<Weights, samples> weights{};
    for (int s = 0; s < samples; ++s) weights[s] = spline_weights((s + 0.5) / samples);
    return weights;
}
constexpr std::array<Weights, samples> sample_weights = weights_of_samples();

/// Signed distance to the ball above where the cone touches it, and to the cone below, and its gradient.
struct Distance {
    double value = 0;
    Vec2 gradient = Vec2::Zero();  // of height and radius
};
Distance distance_at(double height, double radius, const Vec2& touch) {
    if (height * touch.y() < radius * touch.x()) return {height * touch.x() + radius * touch.y() - 1, touch};
    const double length = std::sqrt(height * height + radius * radius), inverse = 1 / length;
    return {length - 1, Vec2(height * inverse, radius * inverse)};
}

/// Unknown 0 is the height of the pole, 2 i - 1 and 2 i are the height and radius of ring i. Sizes are known
/// to the compiler: there are many round ends, and most have one ring or two.
template <int rings>
class Fit {
  public:
    Fit(double sine, std::span<const ProfileRow> rows, const ProfileRow (&below)[2])
        : touch_(sine, std::sqrt(1 - sine * sine)), below_{below[0], below[1]} {
        at_[0] = rows[0].height;
        for (int i = 1; i <= rings; ++i) {
            at_[2 * i - 1] = rows[i].height;
            at_[2 * i] = rows[i].radius;
        }
        start_ = at_;
    }

    /// @param power  of a distance in its weight
    void run(int power) {
        at_ = start_;
        worst_ = 0;
        for (int step = 0; step < plain_steps; ++step) at_ += find_step(0);
        for (const double share : weighed_steps) at_ += share * find_step(power);
    }
    /// The first ring once more, from the other side of the pole, the pole, the rings, and two below.
    using Profile = std::array<ProfileRow, rings + 4>;
    Profile profile() const {
        Profile rows;
        rows[0] = {at_[1], -at_[2]};
        rows[1] = {at_[0], 0};
        for (int i = 1; i <= rings; ++i) rows[i + 1] = {at_[2 * i - 1], at_[2 * i]};
        rows[rings + 2] = below_[0];
        rows[rings + 3] = below_[1];
        return rows;
    }

  private:
    static constexpr int unknowns = 2 * rings + 1;
    using Matrix = Eigen::Matrix<double, unknowns, unknowns>;
    using Vector = Eigen::Matrix<double, unknowns, 1>;

    Vector find_step(int power) {
        Matrix normal = reluctance * Matrix::Identity();
        Vector right = reluctance * (start_ - at_);
        const double scale = worst_ > 0 ? 1 / worst_ : 0;
        worst_ = 0;
        const Profile profile = this->profile();
        for (int first = -1; first < rings; ++first) {
            const ProfileRow* const rows = &profile[first + 1];
            for (const Weights& w : sample_weights) {
                double height = 0, radius = 0;
                for (int j = 0; j < 4; ++j) {
                    height += w[j] * rows[j].height;
                    radius += w[j] * rows[j].radius;
                }
                const Distance d = distance_at(height, radius, touch_);
                const double share = d.value * scale, square = share * share;
                const double weighed = power == 2 ? square : square * square;
                const double weight = (power == 0 ? 1.0 : std::max(least_weight, weighed)) / samples;
                add(first, w, d, weight, normal, right);
                worst_ = std::max(worst_, std::abs(d.value));
            }
        }
        return solved(normal, right);
    }

    /// Solves the normal equations, of which the lower triangle is given. L D L^T, since with sizes that are
    /// known and small this is a tenth of the time of the general solver.
    static Vector solved(Matrix& a, Vector x) {
        for (int k = 0; k < unknowns; ++k)
            for (int i = k + 1; i < unknowns; ++i) {
                const double factor = a(i, k) / a(k, k);
                x[i] -= factor * x[k];
                for (int j = k + 1; j <= i; ++j) a(i, j) -= factor * a(j, k);
            }
        for (int k = unknowns - 1; k >= 0; --k) {
            for (int i = k + 1; i < unknowns; ++i) x[k] -= a(i, k) * x[i];
            x[k] /= a(k, k);
        }
        return x;
    }

    /// Adds a point of the surface between rows first + 1 and first + 2 to the normal equations.
    static void add(int first, const Weights& w, const Distance& d, double weight, Matrix& normal,
                    Vector& right) {
        double change[2 * 4 + 1];  // from the first unknown on that the point depends on
        const int begin = std::max(0, 2 * first - 1), end = std::min(unknowns, 2 * first + 7);
        const auto set = [&](int row, double of_height, double of_radius) {
            if (row > rings) return;
            if (row > 0) change[2 * row - begin] = of_radius * d.gradient.y();
            change[(row > 0 ? 2 * row - 1 : 0) - begin] = of_height * d.gradient.x();
        };
        if (first < 0) {  // the ring beyond the pole is the first one once more, seen from the other side
            set(0, w[1], 0);
            set(1, w[2] + w[0], w[2] - w[0]);
            set(2, w[3], w[3]);
        } else {
            for (int j = 0; j < 4; ++j) set(first + j, w[j], w[j]);
        }
        for (int i = begin; i < end; ++i) {
            const double weighed = weight * change[i - begin];
            for (int j = begin; j <= i; ++j) normal(i, j) += weighed * change[j - begin];
            right[i] -= weighed * d.value;
        }
    }

    Vec2 touch_;
    ProfileRow below_[2];
    Vector at_, start_;
    double worst_ = 0;
};

/// Does each row stand above the next?
template <std::size_t count>
bool stands(const std::array<ProfileRow, count>& profile) {
    for (std::size_t i = 1; i + 2 < count; ++i)
        if (!(profile[i].height > profile[i + 1].height) || (i > 1 && !(profile[i].radius > 0))) return false;
    return true;
}

/// Weights of the fourth power are for rings that have far to go: the worst is all that keeps these in order.
template <int rings>
void fit_rings(double sine, std::span<ProfileRow> rows, const ProfileRow (&below)[2]) {
    Fit<rings> fit(sine, rows, below);
    for (const int power : {2, 4}) {
        fit.run(power);
        const auto profile = fit.profile();
        if (!stands(profile)) continue;
        std::copy_n(profile.begin() + 1, rings + 1, rows.begin());
        return;
    }
}

}  // namespace

void fit_round_end(double sine, std::span<ProfileRow> rows, const ProfileRow (&below)[2]) {
    static_assert(most_round_rings == 8);
    switch (rows.size() - 1) {
        case 1:
            return fit_rings<1>(sine, rows, below);
        case 2:
            return fit_rings<2>(sine, rows, below);
        case 3:
            return fit_rings<3>(sine, rows, below);
        case 4:
            return fit_rings<4>(sine, rows, below);
        case 5:
            return fit_rings<5>(sine, rows, below);
        case 6:
            return fit_rings<6>(sine, rows, below);
        case 7:
            return fit_rings<7>(sine, rows, below);
        case 8:
            return fit_rings<8>(sine, rows, below);
    }
}

}  // namespace sinew::sqm
