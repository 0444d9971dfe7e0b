#include "sinew/sqm/round_end.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

namespace sinew::sqm {
namespace {

constexpr int samples = 9;           // of the surface between two rows
constexpr int plain_steps = 4;       // of Gauss and Newton
constexpr int weighed_steps = 18;    // that weigh what is worst
constexpr double settled = 2e-3;     // radii: rows that move less are where they belong
constexpr double reluctance = 1e-3;  // of rows to slide along the profile, where nothing else holds them

constexpr int most_unknowns = 1 + 2 * static_cast<int>(most_round_rings);
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_unknowns, most_unknowns>;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_unknowns, 1>;
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
    const double length = std::sqrt(height * height + radius * radius);
    return {length - 1, Vec2(height, radius) / length};
}

/// Unknown 0 is the height of the pole, 2 i - 1 and 2 i are the height and radius of ring i.
class Fit {
  public:
    Fit(double sine, std::span<const ProfileRow> rows, const ProfileRow (&below)[2])
        : rings_(static_cast<int>(rows.size()) - 1),
          touch_(sine, std::sqrt(1 - sine * sine)),
          below_{below[0], below[1]},
          at_(2 * rings_ + 1) {
        at_[0] = rows[0].height;
        for (int i = 1; i <= rings_; ++i) {
            at_[2 * i - 1] = rows[i].height;
            at_[2 * i] = rows[i].radius;
        }
        start_ = at_;
    }

    void run() {
        for (int step = 0; step < plain_steps && improve(false) > settled; ++step) {
        }
        for (int step = 0; step < weighed_steps && improve(true) > settled; ++step) {
        }
    }
    ProfileRow row(int i) const {
        if (i < 0) return {at_[1], -at_[2]};  // the other side of the pole
        if (i == 0) return {at_[0], 0};
        if (i <= rings_) return {at_[2 * i - 1], at_[2 * i]};
        return below_[i - rings_ - 1];
    }

  private:
    /// Adds the change of a point that is `weight` of a row moving along `gradient`.
    void move(int row, double weight, const Vec2& gradient, Vector& change) const {
        if (row > rings_) return;
        const int i = row < 0 ? 1 : row;
        change[i == 0 ? 0 : 2 * i - 1] += weight * gradient.x();
        if (i > 0) change[2 * i] += (row < 0 ? -weight : weight) * gradient.y();
    }

    /// One step. @returns how far the rows moved, in radii
    double improve(bool weigh) {
        const Eigen::Index n = at_.size();
        Matrix normal = reluctance * Matrix::Identity(n, n);
        Vector right = reluctance * (start_ - at_), change(n);
        double worst = 0;
        for (int first = -1; first < rings_; ++first) {
            const ProfileRow rows[] = {row(first), row(first + 1), row(first + 2), row(first + 3)};
            for (const Weights& w : sample_weights) {
                double height = 0, radius = 0;
                for (int j = 0; j < 4; ++j) {
                    height += w[j] * rows[j].height;
                    radius += w[j] * rows[j].radius;
                }
                const Distance d = distance_at(height, radius, touch_);
                change.setZero();
                for (int j = 0; j < 4; ++j) move(first + j, w[j], d.gradient, change);
                const double share = worst_ > 0 ? d.value / worst_ : 0;
                const double weight = (weigh ? std::max(1e-2, share * share * share * share) : 1) / samples;
                for (Eigen::Index i = 0; i < n; ++i)
                    for (Eigen::Index j = 0; j <= i; ++j) normal(i, j) += weight * change[i] * change[j];
                right -= weight * d.value * change;
                worst = std::max(worst, std::abs(d.value));
            }
        }
        worst_ = worst;
        const Vector change_of_rows = (weigh ? 0.5 : 1.0) * normal.ldlt().solve(right);
        at_ += change_of_rows;
        return change_of_rows.norm();
    }

    int rings_;
    Vec2 touch_;
    ProfileRow below_[2];
    Vector at_, start_;
    double worst_ = 0;
};

}  // namespace

void fit_round_end(double sine, std::span<ProfileRow> rows, const ProfileRow (&below)[2]) {
    Fit fit(sine, rows, below);
    fit.run();
    const int rings = static_cast<int>(rows.size()) - 1;
    for (int i = 0; i <= rings; ++i)
        if (!(fit.row(i).height > fit.row(i + 1).height) || (i > 0 && !(fit.row(i).radius > 0))) return;
    for (int i = 0; i <= rings; ++i) rows[i] = fit.row(i);
}

}  // namespace sinew::sqm
