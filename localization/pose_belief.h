// SPDX-License-Identifier: MIT
// The estimate of the self-localization.
#pragma once

#include <Eigen/Core>

#include "geometry/angle.h"
#include "geometry/const_or.h"
#include "geometry/pose2.h"

namespace reorient {

struct PoseBelief {
  Pose2 pose;                                            ///< mean of the heaviest cluster of pose particles
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of x, y, rotation in that cluster; m^2, m rad, rad^2
  double cluster_weight = 0.0;                           ///< of that cluster, as a fraction of all particles' weight
  double reflected_weight = 0.0;                         ///< the same near the reflection of `pose`
};

template <typename Visit, ConstOr<PoseBelief> T>
void fields(Visit&& visit, T& belief) {
  visit(belief.pose, belief.covariance, belief.cluster_weight, belief.reflected_weight);
}

/// What a localization estimates in one frame.
struct SensedBelief {
  PoseBelief belief;
  bool tracked = true;                ///< percepts have fitted the belief, or its reflection, for seconds
  double recovery_probability = 0.0;  ///< 0 to 1, that the robot is away from the particles
};

/// The covariance of a belief that is wrong with probability `doubt`. If it is wrong, the robot is anywhere on a field
/// of this size (m, along x and y).
inline Eigen::Matrix3d doubted_covariance(const PoseBelief& belief, double doubt, const Eigen::Vector2d& size) {
  Eigen::Matrix3d anywhere = Eigen::Matrix3d::Zero();
  anywhere.topLeftCorner<2, 2>() = belief.pose.position * belief.pose.position.transpose();
  anywhere.diagonal() += Eigen::Vector3d(size.x() * size.x() / 12.0, size.y() * size.y() / 12.0, kPi * kPi / 3.0);
  return (1.0 - doubt) * belief.covariance + doubt * anywhere;
}

/// Which of the two goals is in view (the paper's goal views).
enum class SeenGoal { unknown, opponent, own };

/// The point on the wall at which the camera looks, according to room awareness. For each position on the field it
/// determines a heading.
struct SeenView {
  double azimuth = 0.0;    ///< of this point, rad, field frame
  double deviation = 0.0;  ///< standard deviation of the azimuth, rad
  double radius = 1.0;     ///< of the wall, m
  double direction = 0.0;  ///< of the camera's view, rad, in the robot's present frame
};

}  // namespace reorient
