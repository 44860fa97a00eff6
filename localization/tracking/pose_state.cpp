// SPDX-License-Identifier: MIT
#include "localization/tracking/pose_state.h"

#include "geometry/pinned_math.h"
#include "geometry/square.h"
#include "localization/tracking/tilt_geometry.h"

namespace reorient {

PoseState::Vector PoseState::values() const {
  Vector values = mean;
  values[kX] = pose.position.x();
  values[kY] = pose.position.y();
  values[kRotation] = pose.rotation;
  return values;
}

void PoseState::predict(const Pose2& step, double time, const MotionModelParameters& motion, double drift,
                        double sway_variance, double sway_time) {
  const Pose2 next = pose * step;
  const Eigen::Vector2d motion_on_field = next.position - pose.position;
  pose = next;
  for (std::size_t j = 0; j < kSize; ++j) {
    covariance[kX][j] -= motion_on_field.y() * covariance[kRotation][j];
    covariance[kY][j] += motion_on_field.x() * covariance[kRotation][j];
  }
  for (std::size_t i = 0; i < kSize; ++i) {
    covariance[i][kX] -= motion_on_field.y() * covariance[i][kRotation];
    covariance[i][kY] += motion_on_field.x() * covariance[i][kRotation];
  }
  const StepNoise noise = step_noise(step, time, motion);
  covariance[kX][kX] += square(noise.position);
  covariance[kY][kY] += square(noise.position);
  covariance[kRotation][kRotation] += square(noise.rotation);
  for (std::size_t i = kTorso; i < kSway; ++i) covariance[i][i] += drift * time;
  const double decay = pinned::exp(-time / sway_time);
  for (std::size_t i = kSway; i < kSize; ++i) {
    mean[i] *= decay;
    for (std::size_t j = 0; j < kSize; ++j) covariance[i][j] *= decay;
    for (std::size_t j = 0; j < kSize; ++j) covariance[j][i] *= decay;
    covariance[i][i] += sway_variance * (1.0 - square(decay));
  }
}

void PoseState::update(const Measurement& measured, const Vector& before) {
  Vector gain{};
  double variance = measured.variance;
  for (std::size_t i = 0; i < kSize; ++i) {
    for (std::size_t j = 0; j < kSize; ++j) gain[i] += covariance[i][j] * measured.row[j];
    variance += measured.row[i] * gain[i];
  }
  const double turned = angle_difference(pose.rotation, before[kRotation]);
  double residual = measured.residual;
  residual += measured.row[kX] * (pose.position.x() - before[kX]);
  residual += measured.row[kY] * (pose.position.y() - before[kY]);
  residual += measured.row[kRotation] * turned;
  for (std::size_t i = kTorso; i < kSize; ++i) residual += measured.row[i] * (mean[i] - before[i]);
  const double inverse = 1.0 / variance;
  const double correction = -residual * inverse;
  pose = Pose2(pose.position.x() + gain[kX] * correction, pose.position.y() + gain[kY] * correction,
               pose.rotation + gain[kRotation] * correction);
  for (std::size_t i = kTorso; i < kSize; ++i) mean[i] += gain[i] * correction;
  for (std::size_t i = 0; i < kSize; ++i) {
    for (std::size_t j = 0; j < kSize; ++j) covariance[i][j] -= gain[i] * gain[j] * inverse;
  }
}

double PoseState::variance_of(const Vector& row) const {
  double variance = 0.0;
  for (std::size_t i = 0; i < kSize; ++i) {
    double sum = 0.0;
    for (std::size_t j = 0; j < kSize; ++j) sum += covariance[i][j] * row[j];
    variance += row[i] * sum;
  }
  return variance;
}

PoseState::Vector PoseState::row_of(const Eigen::Vector2d& normal, const Eigen::Vector2d& point,
                                    const Isometry3& robot_from_camera, std::size_t camera) const {
  const Eigen::Vector2d in_robot = rotated(normal, -pose.rotation);
  const TiltRow tilt = tilt_row(in_robot, point, robot_from_camera, mount_axis(robot_from_camera));
  Vector row{};
  row[kX] = normal.x();
  row[kY] = normal.y();
  row[kRotation] = cross(point, in_robot);
  row[kTorso] = row[kSway] = tilt.roll;
  row[kTorso + 1] = row[kSway + 1] = tilt.pitch;
  row[kMounts + 2 * camera] = tilt.mount_roll;
  row[kMounts + 2 * camera + 1] = tilt.mount_pitch;
  return row;
}

void PoseState::flip() {
  pose = reflect(pose);
  for (const std::size_t i : {kX, kY}) {
    for (std::size_t j = kRotation; j < kSize; ++j) {
      covariance[i][j] = -covariance[i][j];
      covariance[j][i] = -covariance[j][i];
    }
  }
}

}  // namespace reorient
