// SPDX-License-Identifier: MIT
// Where the pixels of one image lie on the ground, and where the ground's points lie in the image.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "geometry/camera.h"
#include "geometry/transform.h"

namespace reorient {

/// One camera in one attitude above the ground. Points are in the robot frame (m), pixels as in CameraModel.
class GroundProjection {
 public:
  /// Nothing for a camera that does not look at the ground from above and roughly upright: numbers that are not
  /// finite, on the ground or far up, rolled by more than 35 degrees, looking (almost) straight down or up.
  static std::optional<GroundProjection> look(const CameraModel& camera, const Isometry3& robot_from_camera);

  const CameraModel& camera() const { return camera_; }
  double camera_height() const { return robot_from_camera_.translation().z(); }

  /// On the ground; nothing at and above the horizon.
  std::optional<Eigen::Vector2d> ground(const Eigen::Vector2d& pixel) const { return at_height(pixel, 0.0); }

  /// On the level plane at a height above the ground (m); nothing where the pixel's ray does not meet it.
  std::optional<Eigen::Vector2d> at_height(const Eigen::Vector2d& pixel, double height) const;

  std::optional<Eigen::Vector2d> pixel(const Eigen::Vector3d& point) const;
  Eigen::Vector3d in_camera(const Eigen::Vector3d& point) const { return camera_from_robot_ * point; }

  /// Along the ground, from the point below the camera.
  double distance(const Eigen::Vector2d& point) const {
    return (point - robot_from_camera_.translation().head<2>()).norm();
  }

  /// Away from the camera along the ground; the zero vector right below it.
  Eigen::Vector2d away(const Eigen::Vector2d& point) const;

  /// Covariance (m^2) of a point on the ground, of which the direction from the camera is known to `deviation`, rad. A
  /// distance on the ground follows from the angle below the horizon, so its error grows with the square.
  Eigen::Matrix2d covariance(const Eigen::Vector2d& point, double deviation) const;
  /// The same where the camera's attitude is known to `attitude_deviation`, rad, and the pixel at which it is seen to
  /// `pixel_deviation`, pixels.
  Eigen::Matrix2d covariance(const Eigen::Vector2d& point, double attitude_deviation, const Eigen::Vector2d& pixel,
                             double pixel_deviation) const;

  /// Row of the horizon in a column. It may lie outside of the image; where the lens is not perspective, the image's
  /// edge is given then.
  double horizon(double column) const;
  double highest_horizon() const;  ///< its least row in the image

  /// How many pixels of a row an angle of 1 rad fills at a pixel; of a perspective lens, in the middle of the image.
  double pixels_per_radian(const Eigen::Vector2d& pixel) const;

  /// How far the image of a vertical edge moves to the right from one row to the next lower one, pixels.
  double vertical_slant(const Eigen::Vector2d& pixel) const;

 private:
  static constexpr std::size_t kHorizonPoints = 33;

  GroundProjection(const CameraModel& camera, const Isometry3& robot_from_camera);
  double find_horizon(double column) const;

  CameraModel camera_;
  Isometry3 robot_from_camera_;
  Isometry3 camera_from_robot_;
  Eigen::Vector3d down_;                          ///< in the camera frame
  std::array<double, kHorizonPoints> horizon_{};  ///< rows at evenly spread columns; used where the horizon is a curve
};

}  // namespace reorient
