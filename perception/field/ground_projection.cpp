// SPDX-License-Identifier: MIT
#include "perception/field/ground_projection.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "geometry/pinned_math.h"

namespace reorient {
namespace {

bool is_upright(const Isometry3& robot_from_camera) {
  constexpr double kLowest = 0.15;   // m; a lying robot's camera is below
  constexpr double kHighest = 2.5;   // m
  constexpr double kSteepest = 0.3;  // cosine of the angle between the image's vertical and gravity
  const double tan_roll_limit = pinned::tan(from_degrees(35.0));
  if (!robot_from_camera.matrix().allFinite()) return false;
  const double height = robot_from_camera.translation().z();
  const Eigen::Vector3d up = robot_from_camera.linear().row(2);  // in the camera frame
  return height > kLowest && height < kHighest && up.z() > kSteepest && std::abs(up.y()) < tan_roll_limit * up.z();
}

}  // namespace

std::optional<GroundProjection> GroundProjection::look(const CameraModel& camera, const Isometry3& robot_from_camera) {
  if (!is_usable(camera) || !is_upright(robot_from_camera)) return std::nullopt;
  return GroundProjection(camera, robot_from_camera);
}

GroundProjection::GroundProjection(const CameraModel& camera, const Isometry3& robot_from_camera)
    : camera_(camera),
      robot_from_camera_(robot_from_camera),
      camera_from_robot_(robot_from_camera.inverse()),
      down_(-robot_from_camera.linear().row(2).transpose()) {
  if (camera_.is_perspective()) return;
  for (std::size_t i = 0; i < horizon_.size(); ++i)
    horizon_[i] = find_horizon(static_cast<double>(i) * (camera_.width - 1.0) / (kHorizonPoints - 1.0));
}

std::optional<Eigen::Vector2d> GroundProjection::at_height(const Eigen::Vector2d& pixel, double height) const {
  constexpr double kFlattest = 1e-3;  // closer to the horizon, the ground is more than 500 m away
  const Eigen::Vector3d ray = robot_from_camera_.linear() * camera_.ray(pixel);
  const Eigen::Vector3d& origin = robot_from_camera_.translation();
  const double climb = height - origin.z();
  if (!(std::abs(ray.z()) > kFlattest) || climb * ray.z() <= 0.0) return std::nullopt;
  return origin.head<2>() + ray.head<2>() * (climb / ray.z());
}

std::optional<Eigen::Vector2d> GroundProjection::pixel(const Eigen::Vector3d& point) const {
  return camera_.project(camera_from_robot_ * point);
}

Eigen::Vector2d GroundProjection::away(const Eigen::Vector2d& point) const {
  const Eigen::Vector2d offset = point - robot_from_camera_.translation().head<2>();
  const double length = offset.norm();
  return length > 1e-9 ? Eigen::Vector2d(offset / length) : Eigen::Vector2d::Zero();
}

Eigen::Matrix2d GroundProjection::covariance(const Eigen::Vector2d& point, double deviation) const {
  const double height = camera_height();
  const double far = distance(point);
  const double along = deviation * (height + far * far / height);
  const double across = deviation * pinned::hypot(far, height);
  const Eigen::Vector2d sight = away(point);
  return across * across * Eigen::Matrix2d::Identity() + (along * along - across * across) * sight * sight.transpose();
}

Eigen::Matrix2d GroundProjection::covariance(const Eigen::Vector2d& point, double attitude_deviation,
                                             const Eigen::Vector2d& pixel, double pixel_deviation) const {
  return covariance(point, pinned::hypot(attitude_deviation, pixel_deviation / pixels_per_radian(pixel)));
}

/// Bisection, since the row is not a simple function of the column. Rays above the row point up, rays below it down.
double GroundProjection::find_horizon(double column) const {
  constexpr int kIterations = 16;
  double above = -0.5, below = camera_.height - 0.5;
  if (camera_.ray({column, above}).dot(down_) > 0.0) return above;
  if (camera_.ray({column, below}).dot(down_) < 0.0) return below;
  for (int i = 0; i < kIterations; ++i) {
    const double middle = 0.5 * (above + below);
    (camera_.ray({column, middle}).dot(down_) > 0.0 ? below : above) = middle;
  }
  return 0.5 * (above + below);
}

double GroundProjection::highest_horizon() const {
  if (camera_.is_perspective()) return std::min(horizon(0.0), horizon(camera_.width - 1.0));
  return *std::min_element(horizon_.begin(), horizon_.end());
}

double GroundProjection::pixels_per_radian(const Eigen::Vector2d& pixel) const {
  if (camera_.is_perspective()) return camera_.focal.x();
  const double angle =
      (camera_.ray(pixel + Eigen::Vector2d(0.5, 0.0)) - camera_.ray(pixel - Eigen::Vector2d(0.5, 0.0))).norm();
  return angle > 1e-9 ? 1.0 / angle : camera_.focal.x();
}

double GroundProjection::horizon(double column) const {
  if (!camera_.is_perspective()) {
    const double place = std::clamp(column / (camera_.width - 1.0), 0.0, 1.0) * (kHorizonPoints - 1.0);
    const std::size_t left = std::min(static_cast<std::size_t>(place), horizon_.size() - 2);
    const double fraction = place - static_cast<double>(left);
    return (1.0 - fraction) * horizon_[left] + fraction * horizon_[left + 1];
  }
  // Rays (1, -u, -v) at right angles to gravity. u follows from the column after the distortion is removed.
  constexpr int kIterations = 3;
  const double target = (column - camera_.center.x()) / camera_.focal.x();
  double u = target;
  double row = 0.0;
  for (int i = 0; i < kIterations; ++i) {
    const double v = (down_.x() - u * down_.y()) / down_.z();
    row = camera_.center.y() + camera_.focal.y() * v;
    const auto seen = camera_.project({1.0, -u, -v});
    if (!seen) break;
    row = seen->y();
    u += target - (seen->x() - camera_.center.x()) / camera_.focal.x();
  }
  return row;
}

double GroundProjection::vertical_slant(const Eigen::Vector2d& pixel) const {
  constexpr double kStep = 0.01;
  const Eigen::Vector3d ray = camera_.ray(pixel);
  const auto lower = camera_.project(ray + kStep * down_);
  if (!lower || lower->y() - pixel.y() < 1e-6) return 0.0;
  const double slant = (lower->x() - pixel.x()) / (lower->y() - pixel.y());
  constexpr double kSteepest = 2.0;  // near a wide lens, verticals are almost parallel to the rows
  return camera_.is_perspective() ? slant : std::clamp(slant, -kSteepest, kSteepest);
}

}  // namespace reorient
