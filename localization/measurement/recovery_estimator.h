// SPDX-License-Identifier: MIT
// Detects that the pose particles have lost the robot.
#pragma once

#include "geometry/bytes.h"

namespace reorient {

/// Augmented Monte Carlo localization (Thrun, Burgard, Fox: Probabilistic Robotics, table 8.3): follows how well the
/// particles fit the observations, as a slow and a fast average. When the fast one is clearly lower, the robot is lost.
class RecoveryEstimator {
 public:
  /// Forgets the usual fit.
  void restart() { *this = RecoveryEstimator(); }
  /// The robot may have moved: the fast average starts again.
  void doubt() { fast_age_ = 0.0; }

  /// Adds the fit of a frame, a likelihood per observation in [0, 1], `elapsed` seconds after the previous frame.
  /// Each average is the true mean until its time constant (s) has passed.
  void update(double fit, double elapsed, double slow_time, double fast_time);

  /// Nothing of the field was in view for `elapsed` seconds, although the cameras worked: the fast average decays with
  /// the time constant `blind_time`, s.
  void see_nothing(double elapsed, double blind_time);

  double slow() const { return slow_; }
  double fast() const { return fast_; }

  /// Probability that the robot is lost: 0 while fast >= margin * slow, 1 if nothing fits. 0 before the first frame.
  double recovery_probability(double margin) const;

  /// Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.age_, self.fast_age_, self.slow_, self.fast_);
    if constexpr (Archive::kReads) self.complete();
  }

 private:
  void complete() const;

  double age_ = 0.0;       ///< s
  double fast_age_ = 0.0;  ///< s since the last doubt()
  double slow_ = 0.0;
  double fast_ = 0.0;
};

}  // namespace reorient
