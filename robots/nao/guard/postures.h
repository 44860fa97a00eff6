// SPDX-License-Identifier: MIT
// The postures in which a NAO is safe, and smooth transitions between them. Angles of sitting and of the arms during
// transitions: Nao Devils 2024. Standing is Reorient's: knees hardly bent, the torso upright over the soles.
#pragma once

#include <array>
#include <cstddef>

#include "robots/nao/lola/joints.h"

namespace reorient::nao {

inline constexpr double kCycle = 0.012;  // s of LoLA

/// Left and right are symmetric; the head looks straight ahead, regardless of requests.
const JointValues& standing_posture();
const JointValues& crouching_posture();  ///< legs as in sitting, the arms in front of the knees
const JointValues& sitting_posture();

/// Moves from one posture to another along a half cosine, so that it starts and ends with zero speed.
class Glide {
 public:
  Glide() = default;
  /// `seconds`: at least one cycle.
  Glide(const JointValues& from, const JointValues& to, double seconds);

  /// Advances by one cycle.
  JointValues step();
  bool is_over() const { return done_ >= 1.0; }

 private:
  JointValues from_{}, to_{};
  double share_ = 1.0;  // fraction of the motion in one cycle
  double done_ = 1.0;   // fraction that is done, from 0 to 1
};

}  // namespace reorient::nao
