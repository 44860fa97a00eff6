// SPDX-License-Identifier: MIT
// What the pose filter believes.
#pragma once

#include <Eigen/Core>

#include "geometry/angle.h"
#include "geometry/const_or.h"
#include "geometry/pose2.h"

namespace reorient {

struct PoseBelief {
  Pose2 pose;                                            ///< mean of the heaviest cluster of pose particles
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of that cluster: x, y, rotation; m^2, m rad, rad^2
  double cluster_weight = 0.0;                           ///< of all particles, in that cluster
  double reflected_weight = 0.0;                         ///< of all particles, near the reflection of `pose`
};

template <typename Visit, ConstOr<PoseBelief> T>
void fields(Visit&& visit, T& belief) {
  visit(belief.pose, belief.covariance, belief.cluster_weight, belief.reflected_weight);
}

/// What a localization estimates in one frame.
struct SensedBelief {
  PoseBelief belief;
  bool tracked = true;                ///< what is seen fits the belief, or its reflection, for seconds
  double recovery_probability = 0.0;  ///< 0 to 1: how sure the pose filter is that the robot is elsewhere
};

/// The covariance (as above) of what may be wrong by a probability of `doubt`: then the robot stands anywhere on a
/// field of this size (m, along x and y).
inline Eigen::Matrix3d doubted_covariance(const PoseBelief& belief, double doubt, const Eigen::Vector2d& size) {
  Eigen::Matrix3d anywhere = Eigen::Matrix3d::Zero();
  anywhere.topLeftCorner<2, 2>() = belief.pose.position * belief.pose.position.transpose();
  anywhere.diagonal() += Eigen::Vector3d(size.x() * size.x() / 12.0, size.y() * size.y() / 12.0, kPi * kPi / 3.0);
  return (1.0 - doubt) * belief.covariance + doubt * anywhere;
}

/// Which of the two goals is in view, where that is known (the paper's goal views).
enum class SeenGoal { unknown, opponent, own };

/// Where on the wall the room says that the camera looked. It gives each place on the field its heading.
struct SeenView {
  double azimuth = 0.0;    ///< of the point on the wall, rad, field frame
  double deviation = 0.0;  ///< standard deviation of the azimuth, rad
  double radius = 1.0;     ///< of the wall, m
  double direction = 0.0;  ///< in which the camera looked, rad, in the robot's present frame
};

}  // namespace reorient
