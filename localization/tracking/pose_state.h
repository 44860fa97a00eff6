// SPDX-License-Identifier: MIT
// A pose, the biases of the camera's angles and the torso's sway, with their covariance: the state of an extended
// Kalman filter (Thrun, Burgard, Fox: Probabilistic Robotics, chapter 3.3).
#pragma once

#include <array>
#include <cstddef>

#include "geometry/camera_bias.h"
#include "geometry/const_or.h"
#include "geometry/pose2.h"
#include "localization/particles/motion_model.h"

namespace reorient {

struct PoseState {
  // Where in `mean` and `covariance`: x, y (m, field), rotation (rad); roll and pitch (rad) of the torso, of both
  // mounts, of the sway.
  static constexpr std::size_t kX = 0, kY = 1, kRotation = 2, kTorso = 3, kMounts = 5, kSway = 9, kSize = 11;
  using Vector = std::array<double, kSize>;
  using Matrix = std::array<Vector, kSize>;

  Pose2 pose;
  Vector mean{};  ///< from kTorso on; the pose stands in `pose`
  Matrix covariance{};

  /// One number that was measured: `residual` is 0 if the state is right; `row` says how it changes with the state.
  struct Measured {
    double residual = 0.0;
    Vector row{};
    double variance = 0.0;
  };

  /// All of it, the pose as well.
  Vector values() const;

  /// The pose moves by `step`, and everything spreads. `drift` (rad^2/s) is of the biases. `sway_variance` (rad^2) and
  /// `sway_time` (s) are of the sway. `time`: s, not negative.
  void predict(const Pose2& step, double time, const MotionModelParameters& motion, double drift, double sway_variance,
               double sway_time);
  /// One step of the filter. `before`: values() when the residual was computed.
  void take(const Measured& measured, const Vector& before);
  /// Of what is measured with this row, by the state alone.
  double variance_of(const Vector& row) const;

  /// How the distance of a point (robot frame, m) from a line changes. `normal`: across the line, of length 1, field
  /// frame. `camera`: 0 is the upper one.
  Vector row_of(const Eigen::Vector2d& normal, const Eigen::Vector2d& point, const Isometry3& robot_from_camera,
                std::size_t camera) const;

  /// The reflected pose; the biases are the robot's and stay.
  void flip();
};

/// All of it, in the order in which it is saved.
template <typename Visit, ConstOr<PoseState> T>
void fields(Visit&& visit, T& state) {
  visit(state.pose, state.mean, state.covariance);
}

}  // namespace reorient
