// SPDX-License-Identifier: MIT
// The error of the torso's measured attitude, estimated with the accelerometer.
#pragma once

#include <cmath>
#include <optional>

#include <Eigen/Core>

#include "geometry/bytes.h"
#include "geometry/camera_bias.h"
#include "geometry/head.h"

namespace reorient {

/// Compares the measured attitude with the direction of gravity, as a mean over some seconds on the feet, in which the
/// accelerations of steps cancel out. Gives only one estimate: all would share the accelerometer's constant error.
class GravityBias {
 public:
  /// One sample of a robot on its feet. `acceleration`: of the torso against free fall, in its own frame, m/s^2.
  /// `time`: s. Returns the torso's bias once, when there are enough samples.
  std::optional<TiltBias> add_sample(const Eigen::Vector3d& acceleration, const TorsoAttitude& measured, double time);
  /// The robot is not on its feet: discards the samples so far.
  void interrupt();

  /// Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.sum_, self.samples_, self.began_, self.is_reported_);
    if constexpr (Archive::kReads) {
      check_bytes(self.samples_ >= 0 && std::isfinite(self.sum_.roll) && std::isfinite(self.sum_.pitch) &&
                      std::isfinite(self.began_),
                  "gravity: the samples have an invalid value");
    }
  }

 private:
  TiltBias sum_;  ///< of the differences between gravity and measured attitude, rad
  int samples_ = 0;
  double began_ = 0.0;  ///< s
  bool is_reported_ = false;
};

}  // namespace reorient
