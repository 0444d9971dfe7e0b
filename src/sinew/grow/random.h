/// @file random.h
/// Random numbers that are the same on every machine.
#pragma once

#include <cstdint>

namespace sinew::lsystem {

/// The finaliser of SplitMix64 (Steele, Lea, Flood, "Fast splittable pseudorandom number generators", OOPSLA
/// 2014).
constexpr std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}
constexpr std::uint64_t golden = 0x9e3779b97f4a7c15u;

/// The key of child `index` of whatever has the key `parent`. Every module draws from a stream of its own, so
/// that what one branch draws changes no other, and a tree keeps its shape when it grows one step further.
constexpr std::uint64_t child_key(std::uint64_t parent, std::uint64_t index) {
    return mix(parent ^ mix((index + 1) * golden));
}

/// A stream of SplitMix64.
class Random {
  public:
    explicit Random(std::uint64_t key = 0) : state_(key) {}
    double uniform() { return static_cast<double>(mix(state_ += golden) >> 11) * 0x1p-53; }  ///< in [0, 1)
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    double normal(double mean, double deviation);  ///< by Box and Muller, two draws each

  private:
    std::uint64_t state_;
};

}  // namespace sinew::lsystem
