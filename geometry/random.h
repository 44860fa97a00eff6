// SPDX-License-Identifier: MIT
// Random numbers that are the same on every machine and in each run with the same seed.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "geometry/angle.h"
#include "geometry/pinned_math.h"

namespace reorient {

/// Scatters similar numbers (the finalizer of splitmix64). Different inputs have different results.
constexpr std::uint64_t scatter(std::uint64_t value) {
  value = (value ^ (value >> 30)) * 0xBF58476D1CE4E5B9ull;
  value = (value ^ (value >> 27)) * 0x94D049BB133111EBull;
  return value ^ (value >> 31);
}

/// xoshiro256++ (Blackman and Vigna, 2019), seeded by splitmix64. A seed and a stream define one sequence. Never
/// generate two numbers in the arguments of one call or in the operands of one operator: their order of evaluation
/// differs between processors and compilers. In braces the order is from left to right.
class Random {
 public:
  using result_type = std::uint64_t;

  explicit Random(std::uint64_t seed, std::uint64_t stream = 0) {
    std::uint64_t mixed = seed ^ (stream * 0x9E3779B97F4A7C15ull);
    for (std::uint64_t& word : state_) word = splitmix(mixed);
  }

  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return ~result_type{0}; }

  result_type operator()() {
    const std::uint64_t result = rotate(state_[0] + state_[3], 23) + state_[0];
    const std::uint64_t shifted = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = rotate(state_[3], 45);
    return result;
  }

  /// In [0, 1).
  double uniform() { return static_cast<double>((*this)() >> 11) * 0x1.0p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// In [0, count).
  std::uint64_t below(std::uint64_t count) {
    return static_cast<std::uint64_t>(uniform() * static_cast<double>(count));
  }

  /// Normal with mean 0 and standard deviation 1 (Box and Muller, 1958).
  double normal() {
    if (has_spare_) {
      has_spare_ = false;
      return spare_;
    }
    const double radius = std::sqrt(-2.0 * pinned::log(1.0 - uniform()));
    const double angle = 2.0 * kPi * uniform();
    const auto [sine, cosine] = pinned::sincos(angle);
    spare_ = radius * sine;
    has_spare_ = true;
    return radius * cosine;
  }

  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.state_, self.spare_, self.has_spare_);
  }

 private:
  static std::uint64_t rotate(std::uint64_t value, int bits) { return (value << bits) | (value >> (64 - bits)); }
  static std::uint64_t splitmix(std::uint64_t& state) {
    state += 0x9E3779B97F4A7C15ull;
    return scatter(state);
  }

  std::array<std::uint64_t, 4> state_{};
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace reorient
