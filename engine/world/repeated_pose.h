// SPDX-License-Identifier: MIT
// A pose that is set again because the robot has flipped it: a hint that the room was learned mirrored.
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
        "a pose that is set, flipped and set again, each within this time of the one before, turns what was learned of "
        "the room by half a turn; 0: never");
}

/// Set poses and flips, in their order. A robot whose room was learned mirrored flips every true pose that is set. One
/// set pose cannot show this, since a wrong one is what flips are for; a person who sees the flip and sets the pose
/// again can.
class RepeatedPose {
 public:
  void note_flip(double time) {
    if (set_at_) flipped_at_ = time;
  }
  /// The robot was carried or fell: what is set next is another pose.
  void forget() { *this = {}; }
  /// A pose was set while the robot believed `belief`. Whether it undoes the flip of the pose that was set before.
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
        check_bytes(!time || std::isfinite(*time), "the time of a set pose is not a number");
      check_bytes(self.set_at_ || !self.flipped_at_, "a flip of no pose");
    }
  }

 private:
  /// Nearer to the reflection of `belief` than to `belief`, by direction and, but for what a robot may be off, by
  /// place: at the center of the field both places are one.
  static bool is_opposite(const Pose2& pose, const Pose2& belief) {
    constexpr double kOff = 0.5;  // m
    return std::abs(angle_difference(pose.rotation, belief.rotation)) > 0.5 * kPi &&
           (pose.position + belief.position).norm() < (pose.position - belief.position).norm() + kOff;
  }

  std::optional<double> set_at_;      // s, of the last set pose
  std::optional<double> flipped_at_;  // s, of the last flip since then
};

}  // namespace reorient
