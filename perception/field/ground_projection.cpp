#include "perception/field/ground_projection.h"

#include <cmath>

#include "geometry/angle.h"
#include "geometry/pinned_math.h"

namespace reorient {
namespace {

bool is_usable(const CameraModel& camera) {
  return camera.width > 0 && camera.height > 0 && camera.focal.allFinite() && camera.center.allFinite() &&
         camera.focal.minCoeff() > 0.0 && std::isfinite(camera.k1) && std::isfinite(camera.k2);
}

bool is_upright(const Isometry3& robot_from_camera) {
  constexpr double kLowest = 0.15;   // m; a lying robot's camera is below
  constexpr double kHighest = 2.5;   // m
  constexpr double kSteepest = 0.3;  // cosine of the angle between the image's vertical and gravity's
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
      down_(-robot_from_camera.linear().row(2).transpose()) {}

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

double GroundProjection::horizon(double column) const {
  // Rays (1, -u, -v) that are at right angles to gravity; u is found from the column by undoing the distortion.
  constexpr int kIterations = 3;
  const double wanted = (column - camera_.center.x()) / camera_.focal.x();
  double u = wanted;
  double row = 0.0;
  for (int i = 0; i < kIterations; ++i) {
    const double v = (down_.x() - u * down_.y()) / down_.z();
    row = camera_.center.y() + camera_.focal.y() * v;
    const auto seen = camera_.project({1.0, -u, -v});
    if (!seen) break;
    row = seen->y();
    u += wanted - (seen->x() - camera_.center.x()) / camera_.focal.x();
  }
  return row;
}

double GroundProjection::vertical_slant(const Eigen::Vector2d& pixel) const {
  constexpr double kStep = 0.01;
  const Eigen::Vector3d ray = camera_.ray(pixel);
  const auto lower = camera_.project(ray + kStep * down_);
  if (!lower || lower->y() - pixel.y() < 1e-6) return 0.0;
  return (lower->x() - pixel.x()) / (lower->y() - pixel.y());
}

}  // namespace reorient
