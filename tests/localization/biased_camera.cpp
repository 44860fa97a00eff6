// SPDX-License-Identifier: MIT
#include "tests/localization/biased_camera.h"

#include <cmath>
#include <optional>
#include <vector>

#include "geometry/field_landmarks.h"

namespace reorient {
namespace {

const CameraModel kUpperCamera = CameraModel::from_fields_of_view(640, 480, from_degrees(56.3), from_degrees(43.7));
constexpr double kBetweenPoints = 0.1;  // m, between line points
constexpr double kFarthest = 4.5;       // m
constexpr double kFarther = 0.02;       // m, to a point farther along a line

std::optional<Eigen::Vector2d> on_ground(const Isometry3& robot_from_camera, const Eigen::Vector2d& pixel) {
  const Eigen::Vector3d ray = robot_from_camera.linear() * kUpperCamera.ray(pixel);
  if (ray.z() > -0.02 * ray.norm()) return std::nullopt;
  const Eigen::Vector2d from_camera = -robot_from_camera.translation().z() / ray.z() * ray.head<2>();
  return Eigen::Vector2d(robot_from_camera.translation().head<2>() + from_camera);
}

}  // namespace

Isometry3 BiasedCamera::measured(const HeadAngles& head) {
  return robot_from_camera(RobotDimensions(), head, {}, RobotDimensions().torso_height);
}

FieldPercept BiasedCamera::look(const Pose2& robot, const HeadAngles& head, const CameraBias& known) {
  const Isometry3 true_camera = corrected(measured(head), truth_, 0);
  const Isometry3 believed_camera = corrected(measured(head), known, 0);
  const Pose2 robot_from_field = robot.inverse();
  FieldPercept percept;
  const auto seen = [&](const Eigen::Vector2d& place, double noise) -> std::optional<Eigen::Vector2d> {
    const Eigen::Vector2d in_robot = robot_from_field * place;
    if (in_robot.norm() > kFarthest) return std::nullopt;
    const auto pixel = kUpperCamera.project(true_camera.inverse() * Eigen::Vector3d(in_robot.x(), in_robot.y(), 0.0));
    if (!pixel || !kUpperCamera.contains(*pixel)) return std::nullopt;
    return on_ground(believed_camera, *pixel + noise * Eigen::Vector2d(random_.normal(), random_.normal()));
  };
  const auto add_line_point = [&](const Eigen::Vector2d& place, const Eigen::Vector2d& along) {
    const auto here = seen(place, 0.0), farther = seen(place + kFarther * along, 0.0);
    const auto noisy = seen(place, pixel_noise_);
    if (!here || !farther || !noisy) return;
    const Eigen::Vector2d direction = *farther - *here;
    percept.line_points.push_back(
        {*noisy, std::remainder(direction_of(direction) + kPi / 2.0, kPi), Eigen::Vector2f::Zero()});
    if (random_.uniform() < false_points)
      percept.line_points.back().position += Eigen::Vector2d(random_.uniform(-1.0, 1.0), random_.uniform(-1.0, 1.0));
  };
  for (const FieldLine& line : field_lines(field_)) {
    const Eigen::Vector2d along = (line.to - line.from).normalized();
    for (double along_line = 0.0; along_line < (line.to - line.from).norm(); along_line += kBetweenPoints)
      add_line_point(line.from + along_line * along, along);
  }
  for (double angle = 0.0; angle < 2.0 * kPi; angle += kBetweenPoints / field_.center_circle_radius)
    add_line_point(field_.center_circle_radius * unit_vector(angle), unit_vector(angle + kPi / 2.0));
  for (const Eigen::Vector2d& post : goal_posts(field_)) {
    if (const auto place = seen(post, pixel_noise_))
      percept.goal_posts.push_back({*place, true, Eigen::Vector2f::Zero(), Eigen::Vector2f::Zero()});
  }
  for (const FieldIntersection& one : field_intersections(field_)) {
    const auto place = seen(one.position, pixel_noise_);
    if (!place) continue;
    Intersection& intersection = percept.intersections.emplace_back();
    intersection.position = *place;
    intersection.kind = one.kind;
    intersection.direction = angle_difference(one.direction, robot.rotation);
  }
  return percept;
}

HeadAngles scanning_head(double time) {
  return {1.2 * std::sin(2.0 * kPi * time / 5.0), 0.25 + 0.15 * std::sin(2.0 * kPi * time / 7.0)};
}

}  // namespace reorient
