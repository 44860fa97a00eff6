// SPDX-License-Identifier: MIT
// Projection of pixels to the ground and of ground points to pixels.
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
  /// Empty for a camera that does not look at the ground from above and roughly upright: with values that are not
  /// finite, on the ground, very high, rolled by more than 35 degrees, or looking (almost) straight down or up.
  static std::optional<GroundProjection> look(const CameraModel& camera, const Isometry3& robot_from_camera);

  const CameraModel& camera() const { return camera_; }
  double camera_height() const { return robot_from_camera_.translation().z(); }

  /// The point on the ground. Empty at and above the horizon.
  std::optional<Eigen::Vector2d> ground(const Eigen::Vector2d& pixel) const { return at_height(pixel, 0.0); }

  /// The point on the horizontal plane at a height above the ground (m). Empty if the pixel's ray does not meet the
  /// plane.
  std::optional<Eigen::Vector2d> at_height(const Eigen::Vector2d& pixel, double height) const;

  std::optional<Eigen::Vector2d> pixel(const Eigen::Vector3d& point) const;
  Eigen::Vector3d in_camera(const Eigen::Vector3d& point) const { return camera_from_robot_ * point; }

  /// Distance along the ground from the point below the camera.
  double distance(const Eigen::Vector2d& point) const {
    return (point - robot_from_camera_.translation().head<2>()).norm();
  }

  /// Direction away from the camera along the ground. The zero vector directly below the camera.
  Eigen::Vector2d away(const Eigen::Vector2d& point) const;

  /// Covariance (m^2) of a point on the ground, if `deviation` (rad) is the standard deviation of the direction from
  /// the camera. The distance follows from the angle below the horizon, so its error grows with the square of the
  /// distance.
  Eigen::Matrix2d covariance(const Eigen::Vector2d& point, double deviation) const;
  /// The same for standard deviations of the camera's attitude (`attitude_deviation`, rad) and of the pixel
  /// (`pixel_deviation`, pixels).
  Eigen::Matrix2d covariance(const Eigen::Vector2d& point, double attitude_deviation, const Eigen::Vector2d& pixel,
                             double pixel_deviation) const;

  /// Row of the horizon in a column. It may lie outside of the image. For a lens that is not perspective, it is then
  /// the image's edge.
  double horizon(double column) const;
  double highest_horizon() const;  ///< its smallest row in the image

  /// Pixels of a row per radian at a pixel. For a perspective lens, in the middle of the image.
  double pixels_per_radian(const Eigen::Vector2d& pixel) const;

  /// Shift of the image of a vertical edge to the right from one row to the next lower one, pixels.
  double vertical_slant(const Eigen::Vector2d& pixel) const;

 private:
  static constexpr std::size_t kHorizonPoints = 33;

  GroundProjection(const CameraModel& camera, const Isometry3& robot_from_camera);
  double find_horizon(double column) const;

  CameraModel camera_;
  Isometry3 robot_from_camera_;
  Isometry3 camera_from_robot_;
  Eigen::Vector3d down_;                          ///< in the camera frame
  std::array<double, kHorizonPoints> horizon_{};  ///< rows at evenly spaced columns; used if the horizon is a curve
};

}  // namespace reorient
