// SPDX-License-Identifier: MIT
// Errors of the angles that a robot measures for its torso and its camera mounts, if they are constant for a long time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "geometry/const_or.h"
#include "geometry/transform.h"

namespace reorient {

/// A small rotation about two horizontal axes, rad.
struct TiltBias {
  double roll = 0.0;   ///< left side up
  double pitch = 0.0;  ///< front down
};
template <typename Visit, ConstOr<TiltBias> T>
void fields(Visit&& visit, T& bias) {
  visit(bias.roll, bias.pitch);
}

/// True minus measured attitude. The torso's error rotates with the robot, a mount's error with its camera. While the
/// head looks straight ahead, only their sum is observable.
struct CameraBias {
  TiltBias torso;
  std::array<TiltBias, 2> mounts;  ///< of the upper and the lower camera
  double deviation = 0.0;          ///< rad, standard deviation of the upper camera's sum, for each axis
};
template <typename Visit, ConstOr<CameraBias> T>
void fields(Visit&& visit, T& bias) {
  visit(bias.torso, bias.mounts, bias.deviation);
}

/// The error that was learned for one body. Other bodies have other errors.
struct KnownBias {
  std::uint64_t body = 0;  ///< digest_of() the body; in a file, combined with the digest of its calibration, if any
  CameraBias bias;
};
template <typename Visit, ConstOr<KnownBias> T>
void fields(Visit&& visit, T& known) {
  visit(known.body, known.bias);
}

/// Prior knowledge of the angles: means, and standard deviations for each axis, rad.
struct BiasPrior {
  CameraBias mean;
  double torso_deviation = 0.0;
  double mount_deviation = 0.0;
};

/// The camera's horizontal direction, of length 1. Zero if the camera looks straight up or down. A mount's roll rotates
/// the camera about this direction, its pitch about the axis to the left of it.
inline Eigen::Vector2d mount_axis(const Isometry3& robot_from_camera) {
  const Eigen::Vector2d ahead = robot_from_camera.linear().col(0).head<2>();
  const double length = ahead.norm();
  return length > 0.0 ? Eigen::Vector2d(ahead / length) : Eigen::Vector2d::Zero();
}

/// The sum of torso and mount for one camera, about the robot's axes.
inline TiltBias bias_of(const CameraBias& bias, std::size_t camera, const Isometry3& robot_from_camera) {
  const TiltBias& mount = bias.mounts[camera];
  const Eigen::Vector2d axis = mount_axis(robot_from_camera);
  return {bias.torso.roll + axis.x() * mount.roll - axis.y() * mount.pitch,
          bias.torso.pitch + axis.y() * mount.roll + axis.x() * mount.pitch};
}

/// The sum for the upper camera while the head looks straight ahead.
inline TiltBias bias_ahead(const CameraBias& bias) { return bias_of(bias, 0, Isometry3::Identity()); }

/// The camera's pose without that bias: rotated about the camera's position.
inline Isometry3 corrected(const Isometry3& robot_from_camera, const CameraBias& bias, std::size_t camera) {
  const TiltBias sum = bias_of(bias, camera, robot_from_camera);
  Isometry3 result = robot_from_camera;
  result.linear() = rotation_about_y(sum.pitch) * rotation_about_x(sum.roll) * robot_from_camera.linear();
  return result;
}

}  // namespace reorient
