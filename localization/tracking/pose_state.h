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
  // Indices in `mean` and `covariance`: x, y (m, field), rotation (rad); roll and pitch (rad) of the torso, of both
  // mounts, of the sway.
  static constexpr std::size_t kX = 0, kY = 1, kRotation = 2, kTorso = 3, kMounts = 5, kSway = 9, kSize = 11;
  using Vector = std::array<double, kSize>;
  using Matrix = std::array<Vector, kSize>;

  Pose2 pose;
  Vector mean{};  ///< valid from kTorso; the pose is in `pose`
  Matrix covariance{};

  /// One scalar measurement. `residual` is 0 if the state is right; `row` is its derivative by the state.
  struct Measurement {
    double residual = 0.0;
    Vector row{};
    double variance = 0.0;
  };

  /// The mean of the whole state, including the pose.
  Vector values() const;

  /// Moves the pose by `step` and adds the process noise. `drift` (rad^2/s): of the biases. `sway_variance` (rad^2) and
  /// `sway_time` (s): of the sway. `time`: s, non-negative.
  void predict(const Pose2& step, double time, const MotionModelParameters& motion, double drift, double sway_variance,
               double sway_time);
  /// Measurement update. `before`: values() when the residual was computed.
  void update(const Measurement& measured, const Vector& before);
  /// Variance that the state contributes to a measurement with this row.
  double variance_of(const Vector& row) const;

  /// Derivative of a point's distance from a line by the state. `point`: m, robot frame. `normal`: unit vector across
  /// the line, field frame. `camera`: 0 is the upper one.
  Vector row_of(const Eigen::Vector2d& normal, const Eigen::Vector2d& point, const Isometry3& robot_from_camera,
                std::size_t camera) const;

  /// Reflects the pose. The biases belong to the robot and stay.
  void flip();
};

/// All fields, in the order in which they are saved.
template <typename Visit, ConstOr<PoseState> T>
void fields(Visit&& visit, T& state) {
  visit(state.pose, state.mean, state.covariance);
}

}  // namespace reorient
