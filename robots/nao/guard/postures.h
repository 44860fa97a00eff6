// SPDX-License-Identifier: MIT
// The postures that a NAO is safe in, and smooth ways from one to the other. Angles of sitting and of the arms on the
// way: Nao Devils 2024; standing is ours: knees hardly bent, the torso upright over the soles.
#pragma once

#include <array>
#include <cstddef>

#include "robots/nao/lola/joints.h"

namespace reorient::nao {

inline constexpr double kCycle = 0.012;  // s of LoLA

/// Left and right mirrored; the head looks ahead, wherever it is to look.
const JointValues& standing_posture();
const JointValues& crouching_posture();  ///< as sitting, the arms in front of the knees
const JointValues& sitting_posture();

/// From one posture to another in cosine's time: neither its beginning nor its end is a jolt.
class Glide {
 public:
  Glide() = default;
  /// `seconds` at least one cycle.
  Glide(const JointValues& from, const JointValues& to, double seconds);

  /// One cycle further.
  JointValues step();
  bool is_over() const { return done_ >= 1.0; }

 private:
  JointValues from_{}, to_{};
  double share_ = 1.0;  // of a cycle
  double done_ = 1.0;   // from 0 to 1
};

}  // namespace reorient::nao
