// SPDX-License-Identifier: MIT
// Gravity as measured in a robot's torso.
#pragma once

#include <Eigen/Core>

#include "geometry/head.h"
#include "geometry/pinned_math.h"

namespace reorient {

inline constexpr double kGravity = 9.81;  // m/s^2

/// The unit vector away from the ground, in the torso's frame.
inline Eigen::Vector3d up_in_torso(const TorsoAttitude& torso) {
  const auto [sin_roll, cos_roll] = pinned::sincos(torso.roll);
  const auto [sin_pitch, cos_pitch] = pinned::sincos(torso.pitch);
  return {-sin_pitch, sin_roll * cos_pitch, cos_roll * cos_pitch};
}

}  // namespace reorient
