// SPDX-License-Identifier: MIT
// Poses and particle sets for property tests.
#pragma once

#include <limits>

#include <rapidcheck.h>

#include "localization/particles/particle_set.h"

namespace reorient {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A pose on the carpet.
inline Pose2 any_pose_on_carpet() {
  const double x = *rc::gen::inRange(-5200, 5200) * 1e-3;
  const double y = *rc::gen::inRange(-3700, 3700) * 1e-3;
  return {x, y, *rc::gen::inRange(-3141, 3142) * 1e-3};
}

/// 1 to 59 particles anywhere, with very different weights of sum 1.
inline ParticleSet any_particles() {
  ParticleSet particles(static_cast<std::size_t>(*rc::gen::inRange(1, 60)));
  Random random(*rc::gen::arbitrary<std::uint64_t>());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    particles.set_pose(i, {random.uniform(-6.0, 6.0), random.uniform(-4.5, 4.5), random.uniform(-kPi, kPi)});
    particles.weight[i] = static_cast<float>(std::pow(random.uniform(), 4.0));
  }
  normalize_weights(particles);
  return particles;
}

inline bool same(const ParticleSet& a, const ParticleSet& b) {
  return a.x == b.x && a.y == b.y && a.rotation == b.rotation && a.cosine == b.cosine && a.sine == b.sine &&
         a.weight == b.weight;
}

}  // namespace reorient
