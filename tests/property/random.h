/// @file random.h
/// Random numbers that are the same with every standard library.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "sinew/base/vec.h"

namespace sinew::property {

class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }  ///< in [0, 1)
    double between(double low, double high) { return low + (high - low) * unit(); }
    int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
    int whole(int low, int high) { return low + below(high - low + 1); }
    bool chance(double share) { return unit() < share; }

    Vec3 direction() {
        const double z = between(-1, 1), angle = between(0, 2 * M_PI), r = std::sqrt(1 - z * z);
        return {r * std::cos(angle), r * std::sin(angle), z};
    }
    Vec3 in_cube(double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }

  private:
    std::mt19937_64 engine_;
};

}  // namespace sinew::property
