// SPDX-License-Identifier: MIT
// Detects a pose that is set again after a flip: a sign that the room was learned mirrored.
#pragma once

#include <cmath>
#include <optional>

#include "geometry/bytes.h"
#include "geometry/pose2.h"

namespace reorient {

struct RepeatedPoseParameters {
  double within = 30.0;
};

template <typename Visit>
void describe(RepeatedPoseParameters& p, Visit&& visit) {
  visit("within", p.within, 0.0, 600.0, "s",
        "longest time between setting a pose, its flip, and setting it again, after which the learned room is "
        "rotated by 180 degrees; 0: never");
}

/// Stores the last set pose and its flip. A robot whose room was learned mirrored flips every correct pose that is set.
/// A single flip does not show this, since it may correct a wrong pose. If the operator sees the flip and sets the pose
/// again, the flip was wrong.
class RepeatedPose {
 public:
  void note_flip(double time) {
    if (set_at_) flipped_at_ = time;
  }
  /// The robot was lifted or fell: the next set pose is a different one.
  void forget() { *this = {}; }
  /// A pose was set while the robot believed `belief`. Returns whether it undoes the flip of the previous set pose.
  bool note_set(const Pose2& pose, const Pose2& belief, double time, const RepeatedPoseParameters& parameters) {
    const auto is_soon = [&](double from, double to) { return to - from < parameters.within; };
    const bool undoes =
        flipped_at_ && is_soon(*set_at_, *flipped_at_) && is_soon(*flipped_at_, time) && is_opposite(pose, belief);
    forget();
    if (!undoes) set_at_ = time;
    return undoes;
  }

  /// Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.set_at_, self.flipped_at_);
    if constexpr (Archive::kReads) {
      for (const std::optional<double>& time : {self.set_at_, self.flipped_at_})
        check_bytes(!time || std::isfinite(*time), "repeated pose: time of a set pose: expected a finite number");
      check_bytes(self.set_at_ || !self.flipped_at_, "repeated pose: flip without a set pose");
    }
  }

 private:
  /// Whether it is nearer to the reflection of `belief` than to `belief` in direction and, within a tolerance, in
  /// position: at the center of the field both positions are the same.
  static bool is_opposite(const Pose2& pose, const Pose2& belief) {
    constexpr double kOff = 0.5;  // m
    return std::abs(angle_difference(pose.rotation, belief.rotation)) > 0.5 * kPi &&
           (pose.position + belief.position).norm() < (pose.position - belief.position).norm() + kOff;
  }

  std::optional<double> set_at_;      // s, of the last set pose
  std::optional<double> flipped_at_;  // s, of the last flip since then
};

}  // namespace reorient
