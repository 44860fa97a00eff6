// SPDX-License-Identifier: MIT
// The pose particles as a structure of arrays, and the standard operations of a particle filter.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/bytes.h"
#include "geometry/pose2.h"
#include "geometry/random.h"
#include "localization/particles/binary_angle.h"

namespace reorient {

/// Weighted poses on the field. All arrays have the same length; `cosine` and `sine` are those of `rotation`.
struct ParticleSet {
  std::vector<float> x;  ///< m
  std::vector<float> y;  ///< m
  std::vector<BinaryAngle> rotation;
  std::vector<float> cosine;
  std::vector<float> sine;
  std::vector<float> weight;  ///< sum: 1

  ParticleSet() = default;
  /// `count` particles of equal weight at the origin.
  explicit ParticleSet(std::size_t count);

  std::size_t size() const { return x.size(); }
  Pose2 pose(std::size_t index) const { return {x[index], y[index], to_radians(rotation[index])}; }
  void set_pose(std::size_t index, const Pose2& pose);
  void set_rotation(std::size_t index, BinaryAngle angle);

  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.x, self.y, self.rotation, self.weight);
    if constexpr (Archive::kReads) self.complete();
  }

 private:
  void complete();
};

/// Roughly normal with mean 0 and standard deviation 1, within +-3.5: the sum of four 16-bit uniform numbers (Irwin and
/// Hall). A particle's noise needs no tails, but it must be fast and the same on every machine.
inline float rough_normal(Random& random) {
  const std::uint64_t bits = random();
  const auto sum =
      static_cast<std::int32_t>((bits & 0xFFFF) + ((bits >> 16) & 0xFFFF) + ((bits >> 32) & 0xFFFF) + (bits >> 48));
  return static_cast<float>(sum - 131070) * (1.0f / 37837.2f);
}

/// Multiplies each weight by the likelihood exp(-fraction * cost) and normalizes the weights. Only differences of costs
/// matter: before the normalization the best particle keeps its weight, and none falls to zero. `costs`, one for each
/// particle, is overwritten.
void weigh(ParticleSet& particles, std::vector<float>& costs, float fraction);

/// Scales the weights to the sum 1. Makes them equal if their sum is zero or not finite.
void normalize_weights(ParticleSet& particles);

/// 1 / sum of squared weights: between 1 and size().
double effective_sample_size(const ParticleSet& particles);

/// Systematic resampling (Thrun, Burgard, Fox: Probabilistic Robotics, table 4.4): fills `to`, whose size does not
/// change, with particles of `from` in proportion to their weights. `offset`: a random number in [0, 1).
void resample_systematic(const ParticleSet& from, ParticleSet& to, double offset);

}  // namespace reorient
