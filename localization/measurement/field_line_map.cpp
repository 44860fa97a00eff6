// SPDX-License-Identifier: MIT
#include "localization/measurement/field_line_map.h"

#include <algorithm>
#include <cmath>

#include "geometry/field_landmarks.h"

namespace reorient {

FieldLineMap::FieldLineMap(const FieldDimensions& field) : circle_(field.center_circle_radius) {
  for (const FieldLine& line : field_lines(field)) {
    const double length = (line.to - line.from).norm();
    lines_.push_back({line.from, (line.to - line.from) / length, length});
  }
}

std::optional<NearestFieldLine> FieldLineMap::nearest(const Eigen::Vector2d& place,
                                                      const Eigen::Vector2d& direction) const {
  std::optional<NearestFieldLine> best;
  double next = std::numeric_limits<double>::infinity();
  const auto offer = [&](const Eigen::Vector2d& normal, double distance) {
    if (!best) {
      best = NearestFieldLine{normal, distance};
    } else if (std::abs(distance) < std::abs(best->distance)) {
      next = std::min(next, std::abs(best->distance));
      *best = {normal, distance};
    } else {
      next = std::min(next, std::abs(distance));
    }
  };
  for (const Line& line : lines_) {
    if (std::abs(line.along.dot(direction)) < least_cosine_) continue;
    const Eigen::Vector2d from_start = place - line.from;
    const double along = from_start.dot(line.along);
    if (along < 0.0 || along > line.length) continue;
    offer({-line.along.y(), line.along.x()}, cross(line.along, from_start));
  }
  const double radius = place.norm();
  if (radius > 1e-6 && std::abs(place.dot(direction)) < most_sine_ * radius) offer(place / radius, radius - circle_);
  if (best) best->next = next;
  return best;
}

double FieldLineMap::length_in_view(const Pose2& robot, const CameraModel& camera, const Isometry3& robot_from_camera,
                                    double farthest) const {
  constexpr double kStep = 0.2;  // m
  const Pose2 robot_from_field = robot.inverse();
  const Isometry3 camera_from_robot = robot_from_camera.inverse();
  double length = 0.0;
  for (const Line& line : lines_) {
    for (double along = 0.5 * kStep; along < line.length; along += kStep) {
      const Eigen::Vector2d place = robot_from_field * (line.from + along * line.along);
      if (place.squaredNorm() > farthest * farthest) continue;
      const auto pixel = camera.project(camera_from_robot * Eigen::Vector3d(place.x(), place.y(), 0.0));
      if (pixel && camera.contains(*pixel)) length += kStep;
    }
  }
  return length;
}

}  // namespace reorient
