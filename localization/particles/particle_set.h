// SPDX-License-Identifier: MIT
// The pose particles, a structure of arrays, and what every particle filter does with them.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/bytes.h"
#include "geometry/pose2.h"
#include "geometry/random.h"
#include "localization/particles/binary_angle.h"

namespace reorient {

/// Weighted poses on the field. All arrays are of one length; `cosine` and `sine` belong to `rotation`.
struct ParticleSet {
  std::vector<float> x;  ///< m
  std::vector<float> y;  ///< m
  std::vector<BinaryAngle> rotation;
  std::vector<float> cosine;
  std::vector<float> sine;
  std::vector<float> weight;  ///< adds up to 1

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
/// Hall). A particle's noise needs no tails, but it needs to be cheap and the same on every machine.
inline float rough_normal(Random& random) {
  const std::uint64_t bits = random();
  const auto sum =
      static_cast<std::int32_t>((bits & 0xFFFF) + ((bits >> 16) & 0xFFFF) + ((bits >> 32) & 0xFFFF) + (bits >> 48));
  return static_cast<float>(sum - 131070) * (1.0f / 37837.2f);
}

/// Multiplies each weight with the likelihood of what its particle explains, exp(-share * cost), and makes the weights
/// add up to 1. Only differences of costs matter: the best particle keeps its weight, and none falls to zero. `costs`,
/// as many as particles, is spent.
void weigh(ParticleSet& particles, std::vector<float>& costs, float share);

/// Makes the weights add up to 1; all alike where their sum is zero or not finite.
void normalize_weights(ParticleSet& particles);

/// 1 / sum of squared weights: between 1 and size().
double effective_sample_size(const ParticleSet& particles);

/// Systematic resampling (Thrun, Burgard, Fox: Probabilistic Robotics, table 4.4): fills all of `to`, which keeps its
/// own size, with particles of `from` in proportion to their weights. `offset` in [0, 1) is the one random number.
void resample_systematic(const ParticleSet& from, ParticleSet& to, double offset);

}  // namespace reorient
