// SPDX-License-Identifier: MIT
// What the accelerometer says of the torso's measured attitude.
#pragma once

#include <cmath>
#include <optional>

#include <Eigen/Core>

#include "geometry/bytes.h"
#include "geometry/camera_bias.h"
#include "geometry/head.h"

namespace reorient {

/// Compares the measured attitude with the direction of gravity, as a mean over some seconds on the feet, in which the
/// accelerations of steps cancel out. An accelerometer has a constant error of its own, so it is asked only once.
class GravityBias {
 public:
  /// One sample of a robot on its feet. `acceleration`: of the torso against free fall, in its own frame, m/s^2.
  /// `time`: s. Returns the torso's bias when enough was felt, and never again.
  std::optional<TiltBias> feel(const Eigen::Vector3d& acceleration, const TorsoAttitude& measured, double time);
  /// The robot does not stand on its feet: what was felt so far does not count.
  void interrupt();

  /// Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.sum_, self.samples_, self.began_, self.is_told_);
    if constexpr (Archive::kReads) {
      check_bytes(self.samples_ >= 0 && std::isfinite(self.sum_.roll) && std::isfinite(self.sum_.pitch) &&
                      std::isfinite(self.began_),
                  "what was felt of gravity is not a number");
    }
  }

 private:
  TiltBias sum_;  ///< of the differences, rad
  int samples_ = 0;
  double began_ = 0.0;  ///< s
  bool is_told_ = false;
};

}  // namespace reorient
