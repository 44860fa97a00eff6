// SPDX-License-Identifier: MIT
// Notices that the pose particles have lost the robot.
#pragma once

#include "geometry/bytes.h"

namespace reorient {

/// Augmented Monte Carlo localization (Thrun, Burgard, Fox: Probabilistic Robotics, table 8.3): follows how well the
/// particles fit the observations, once slowly and once fast. When the fast value falls behind, the robot is lost.
class RecoveryEstimator {
 public:
  /// Forgets what fit is usual here.
  void restart() { *this = RecoveryEstimator(); }
  /// The robot may be elsewhere by now: the present fit is that from now on.
  void doubt() { fast_age_ = 0.0; }

  /// Takes in the fit of a frame, a likelihood per observation in [0, 1], `elapsed` seconds after the one before.
  /// Both averages are true means until their time constants (s) have passed.
  void update(double fit, double elapsed, double slow_time, double fast_time);

  /// Nothing of the field was seen for `elapsed` seconds, although the robot looked: the present fit fades, and is gone
  /// after some times `blind_time`, s.
  void see_nothing(double elapsed, double blind_time);

  double slow() const { return slow_; }
  double fast() const { return fast_; }

  /// How sure it is that the robot is lost: 0 while fast >= margin * slow, 1 where nothing fits any more. 0 before the
  /// first frame.
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
  double fast_age_ = 0.0;  ///< s since the doubt
  double slow_ = 0.0;
  double fast_ = 0.0;
};

}  // namespace reorient
